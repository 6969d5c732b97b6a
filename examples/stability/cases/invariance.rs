//! The same scene at other sizes.

use crate::cases::self_intersection::ball;
use crate::naive::origin::Origin;
use crate::page::Page;
use crate::picture::differing;

pub fn write(page: &mut Page) -> Result<(), String> {
    let powers = [-20, -10, -5, 5, 10, 20];
    let mut rows = vec![["origin".to_owned()].into_iter().chain(powers.map(|k| format!("2^{k}"))).collect::<Vec<_>>()];
    for origin in [Origin::AlongRay(1e-3), Origin::AlongNormal(1e-3), Origin::ErrorBound] {
        let unit = ball(origin, 1.0);
        let counts = powers.map(|k| differing(&ball(origin, (k as f32).exp2()), &unit).to_string());
        rows.push([origin.to_string()].into_iter().chain(counts).collect());
    }
    page.text(
        "
## Scale invariance

A scene scaled by a power of 2 has the same digits, so it should have the same picture. The ball on the ground of above, of 43,200
pixels; how many differ from those at size 1:
",
    );
    page.table(&rows);
    page.text(
        "No length in the library is absolute: every bound is a number of roundings of the numbers at hand. All built-in \
         scenes, and one with every shape, light, pattern and medium, have the same bits at every 2^k from −20 to 20 \
         (`tests/scale_invariance.rs`).",
    );
    Ok(())
}
