//! A name that is no quantity of the collision: which was meant, or which there are.

use super::super::document::{Faults, listed};
use super::super::literal::Words;
use crate::diagnostic::near;
use crate::mechanics::{LATER, Quantity};

/// Reports a quantity that does not exist; `others` are names that may stand there too.
pub fn unknown(words: &Words, others: &[String], faults: &mut Faults) {
    unknown_at(words.span(), "quantity", words.get_ref(), others, faults);
}

/// As [`unknown`], at a place within a text; `what` is what the name was to be.
pub fn unknown_at(span: std::ops::Range<usize>, what: &str, name: &str, others: &[String], faults: &mut Faults) {
    let mut names: Vec<String> = Quantity::all().iter().map(Quantity::to_string).collect();
    names.extend_from_slice(others);
    let later = format!("{}.{name}", LATER[0]);
    if later.parse::<Quantity>().is_ok() {
        let label = "this sphere has no part in the first impact";
        let help = format!("say which impact you mean, `{later}`; or name a sphere of the first, *A* or *B*");
        return faults.report(span, format!("unknown {what} `{name}`"), label, help);
    }
    if let Some(meant) = counted(name) {
        let label = "an impact after the first is named in words";
        return faults.report(span, format!("unknown {what} `{name}`"), label, format!("did you mean `{meant}`?"));
    }
    let help = match near(name, names.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{near}`?"),
        None => match Quantity::meant(name).filter(|_| !name.contains('.')) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => siblings(name, &names),
        },
    };
    let label = "no quantity of the collision has this name";
    faults.report(span, format!("unknown {what} `{name}`"), label, help);
}

/// `2.B.after.speed`: a quantity with the number of its impact.
fn counted(name: &str) -> Option<String> {
    let (number, rest) = name.split_once('.')?;
    let meant = match number.parse().ok()? {
        0_usize => return None,
        1 => rest.to_owned(),
        number => format!("{}.{rest}", LATER.get(number - 2)?),
    };
    meant.parse::<Quantity>().is_ok().then_some(meant)
}

/// What may follow the part of a name that is right.
fn siblings(name: &str, names: &[String]) -> String {
    let mut stem = name;
    while let Some((shorter, _)) = stem.rsplit_once('.') {
        stem = shorter;
        let start = format!("{stem}.");
        let after: Vec<&str> = names.iter().filter_map(|name| name.strip_prefix(&start)).collect();
        if !after.is_empty() {
            return format!("after `{start}` may stand {}", listed(&after));
        }
    }
    "quantities are `A.after.speed`, `B.before.n`, `impulse.magnitude`, `ke.lost`, `e` and others like them".to_owned()
}
