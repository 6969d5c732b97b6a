//! Names of functions as a reader likes them.

/// The last two parts of a function's path, without its parameters; for a closure, those of the function it is in.
pub fn short(symbol: &str) -> String {
    let path = full(symbol);
    let plain = without_parameters(&path);
    let parts: Vec<&str> = plain.split("::").filter(|part| !part.is_empty() && !part.starts_with('{')).collect();
    let from = parts.len().saturating_sub(2);
    parts.get(from..).unwrap_or_default().join("::")
}

/// A function's path, demangled.
pub fn full(symbol: &str) -> String {
    format!("{:#}", rustc_demangle::demangle(symbol))
}

/// `<a::B<f32> as c::D>::e::<F>` becomes `a::B::e`.
fn without_parameters(path: &str) -> String {
    let mut plain = String::new();
    let mut depth = 0_u32;
    let mut is_trait = false;
    // An implementation's type stands in angle brackets at the beginning.
    let (path, base) = path.strip_prefix('<').map_or((path, 0), |path| (path, 1));
    let mut open = base;
    for (place, letter) in path.char_indices() {
        match letter {
            '<' => depth += 1,
            '>' if depth > 0 => depth -= 1,
            '>' if open > 0 => (open, is_trait) = (0, false),
            ' ' if depth == 0 && open > 0 && path.get(place..).is_some_and(|rest| rest.starts_with(" as ")) => {
                is_trait = true;
            }
            _ if depth == 0 && !is_trait => plain.push(letter),
            _ => {}
        }
    }
    plain
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parameters_are_left_out() {
        assert_eq!(without_parameters("<a::B<f32> as c::D<x::Y>>::e::<F>"), "a::B::e::");
        assert_eq!(without_parameters("<a::B<f32, 5>>::e::<a::F<'_>>"), "a::B::e::");
        assert_eq!(without_parameters("a::b::<f32>"), "a::b::");
        assert_eq!(without_parameters("<a::B>::c::<1>::{closure#0}"), "a::B::c::::{closure#0}");
        assert_eq!(short("memcpy"), "memcpy");
        let closure = "_ZN4whit5trace5split15Facing$LT$T$GT$4both28_$u7b$$u7b$closure$u7d$$u7d$17heabda4ab4405a1e5E";
        assert_eq!(short(closure), "Facing::both");
        assert_eq!(short("_RNvNtNtCsjc7sn2q0iDy_17compiler_builtins5float3mul8___mulsf3"), "mul::__mulsf3");
    }
}
