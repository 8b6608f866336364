//! The quantity that a name was to be which is none: for `A.after.sped`, `A.after.speed`.

use crate::diagnostic::near;
use crate::mechanics::{LATER, Quantity};

/// What is wrong with a name that no quantity has, and one thing to try; `others` are names that may stand there too.
pub fn name_meant(name: &str, others: &[String]) -> (&'static str, String) {
    let later = format!("{}.{name}", LATER[0]);
    if is_quantity(&later) {
        let help = format!("say which impact you mean, `{later}`; or name a sphere of the first, *A* or *B*");
        return ("this sphere has no part in the first impact", help);
    }
    let did_you_mean = |meant: &str| format!("did you mean `{meant}`?");
    if let Some(meant) = counted(name) {
        return ("an impact after the first is named in words", did_you_mean(&meant));
    }
    let label = "no quantity of the collision has this name";
    if let Some((after, before)) = without_moment(name) {
        return (label, format!("did you mean `{after}` or `{before}`?"));
    }
    let mut names: Vec<String> = Quantity::all().iter().map(Quantity::to_string).collect();
    names.extend_from_slice(others);
    let meant = near(name, names.iter().map(String::as_str)).map(str::to_owned);
    let in_words = || Quantity::meant(name).filter(|_| !name.contains('.')).map(|meant| meant.to_string());
    let help = match meant.or_else(in_words) {
        Some(meant) => did_you_mean(&meant),
        None => siblings(name, &names),
    };
    (label, help)
}

fn is_quantity(name: &str) -> bool {
    name.parse::<Quantity>().is_ok()
}

/// `B.x`: a quantity that does not say when; the same after the impact and before it.
fn without_moment(name: &str) -> Option<(String, String)> {
    let (sphere, rest) = name.rsplit_once('.')?;
    let [after, before] = ["after", "before"].map(|moment| format!("{sphere}.{moment}.{rest}"));
    (is_quantity(&after) && is_quantity(&before)).then_some((after, before))
}

/// `2.B.after.speed`: a quantity with the number of its impact.
fn counted(name: &str) -> Option<String> {
    let (number, rest) = name.split_once('.')?;
    let meant = match number.parse().ok()? {
        0_usize => return None,
        1 => rest.to_owned(),
        number => format!("{}.{rest}", LATER.get(number - 2)?),
    };
    is_quantity(&meant).then_some(meant)
}

/// What may follow the part of a name that is right.
fn siblings(name: &str, names: &[String]) -> String {
    let mut stem = name;
    while let Some((shorter, _)) = stem.rsplit_once('.') {
        stem = shorter;
        let start = format!("{stem}.");
        let after = names.iter().filter_map(|name| name.strip_prefix(&start)).map(|rest| format!("`{rest}`"));
        let after: Vec<String> = after.collect();
        if !after.is_empty() {
            return format!("after `{start}` may stand {}", after.join(", "));
        }
    }
    "quantities are `A.after.speed`, `B.before.n`, `impulse.magnitude`, `ke.lost`, `e` and others like them".to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_no_quantity_has_is_told_which_was_meant() {
        for (name, help) in [
            ("A.after.sped", "did you mean `A.after.speed`?"),
            ("B.x", "did you mean `B.after.x` or `B.before.x`?"),
            ("second.C.speed", "did you mean `second.C.after.speed` or `second.C.before.speed`?"),
            ("2.B.after.speed", "did you mean `second.B.after.speed`?"),
            (
                "C.after.speed",
                "say which impact you mean, `second.C.after.speed`; or name a sphere of the first, *A* or *B*",
            ),
            ("speed of A", "did you mean `A.after.speed`?"),
            (
                "colour",
                "quantities are `A.after.speed`, `B.before.n`, `impulse.magnitude`, `ke.lost`, `e` and others like them",
            ),
        ] {
            assert_eq!(name_meant(name, &[]).1, help, "{name}");
        }
    }
}
