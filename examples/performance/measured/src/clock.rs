//! How long something takes.

use cpu_time::ProcessTime;

/// What a function gives, and the nanoseconds of processor time that it took.
pub fn timed<T>(f: impl FnOnce() -> T) -> (T, f64) {
    let start = ProcessTime::now();
    let result = f();
    (result, start.elapsed().as_secs_f64() * 1e9)
}
