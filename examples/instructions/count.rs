//! What is counted of a subject.

use std::path::Path;

use crate::callgrind::{self, Counts};
use crate::counted::FUNCTION;

/// Executed instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// In the program itself.
    pub instructions: u64,
    /// In the libraries of the system, which has other copies of `memcpy` for other processors.
    pub elsewhere: u64,
}

impl Count {
    /// Runs a program on a subject, and counts from where [`FUNCTION`] begins to where it ends.
    pub fn take(program: &Path, subject: &str) -> Result<Self, String> {
        let toggle = format!("--toggle-collect={FUNCTION}");
        let counts = callgrind::count(&["--collect-atstart=no", &toggle], program, &["--run", subject])?;
        let count = Self::sum(&counts);
        if count.instructions == 0 { Err(format!("`{subject}`: nothing was counted")) } else { Ok(count) }
    }

    fn sum(counts: &Counts) -> Self {
        let all: u64 = counts.values().sum();
        let elsewhere = counts.get(&None).copied().unwrap_or_default();
        Self { instructions: all - elsewhere, elsewhere }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_a_program_and_of_libraries() {
        let counts = Counts::from([(None, 30), (Some(3), 9), (Some(7), 100)]);
        assert_eq!(Count::sum(&counts), Count { instructions: 109, elsewhere: 30 });
    }
}
