//! Counts against those that are recorded.

use crate::record::Record;

/// How many hundredths more a subject may take: by the compiler that the record is of, and by another.
pub const SLACK: u64 = 3;
pub const SLACK_ELSEWHERE: u64 = 25;

/// Lines for the user, and those of them about what takes too much.
pub fn compare(recorded: &[Record], now: &[Record]) -> (Vec<String>, Vec<String>) {
    let (mut lines, mut worse) = (Vec::new(), Vec::new());
    for record in now {
        let before = recorded.iter().find(|before| before.scene == record.scene);
        let (line, is_worse) = before.map_or_else(
            || (format!("`{}`: {} instructions, and none are recorded", record.scene, record.instructions), true),
            |before| compare_one(before, record),
        );
        if is_worse {
            worse.push(line.clone());
        }
        lines.push(line);
    }
    (lines, worse)
}

fn compare_one(before: &Record, now: &Record) -> (String, bool) {
    let slack = if before.machine.compiler == now.machine.compiler { SLACK } else { SLACK_ELSEWHERE };
    let percent = 100.0 * (now.instructions as f64 / before.instructions.max(1) as f64 - 1.0);
    let mut line = format!(
        "`{}`: {} instructions, {} recorded: {percent:+.2} %, at most +{slack} %",
        now.scene, now.instructions, before.instructions
    );
    if before.rays != now.rays {
        let count = |rays: Option<u64>| rays.map_or("no".to_owned(), |rays| rays.to_string());
        line += &format!("; {} rays, {} recorded", count(now.rays), count(before.rays));
    }
    (line, 100 * now.instructions > (100 + slack) * before.instructions)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Machine;

    fn record(scene: &str, instructions: u64, compiler: &str) -> Record {
        let machine = Machine { compiler: compiler.to_owned(), host: "here".to_owned() };
        Record { scene: scene.to_owned(), instructions, rays: Some(10), machine }
    }

    fn worse(instructions: u64, compiler: &str) -> Vec<String> {
        let recorded = [record("card", 1000, "rustc 1"), record("glass", 1000, "rustc 1")];
        compare(&recorded, &[record("card", instructions, compiler), record("glass", instructions, compiler)]).1
    }

    #[test]
    fn all_that_are_worse_are_told() {
        assert_eq!(worse(500, "rustc 1").len(), 0);
        assert_eq!(worse(1030, "rustc 1").len(), 0);
        let told = worse(1031, "rustc 1");
        assert_eq!(told.len(), 2);
        assert_eq!(told[0], "`card`: 1031 instructions, 1000 recorded: +3.10 %, at most +3 %");
    }

    #[test]
    fn another_compiler_may_take_more() {
        assert_eq!(worse(1250, "rustc 2").len(), 0);
        let told = worse(1251, "rustc 2");
        assert_eq!(told[1], "`glass`: 1251 instructions, 1000 recorded: +25.10 %, at most +25 %");
    }

    #[test]
    fn what_is_not_recorded_is_told() {
        let (_, worse) = compare(&[], &[record("card", 1000, "rustc 1")]);
        assert_eq!(worse, ["`card`: 1000 instructions, and none are recorded"]);
    }

    #[test]
    fn other_rays_are_told() {
        let before = Record { rays: None, ..record("card", 1000, "rustc 1") };
        let (lines, worse) = compare(&[before], &[record("card", 900, "rustc 1")]);
        assert!(lines[0].ends_with("-10.00 %, at most +3 %; 10 rays, no recorded") && worse.is_empty());
    }
}
