//! What the words of a line say of a component: that it is along the line of centres, or across it.

/// What stands between two things that are said.
const BETWEEN: [&str; 3] = [",", ";", " and "];

/// The clauses of a line.
pub(super) fn clauses(typed: &str) -> Vec<&str> {
    let mut all = vec![typed];
    for sign in BETWEEN {
        all = all.into_iter().flat_map(|clause| clause.split(sign)).collect();
    }
    all.retain(|clause| !clause.trim().is_empty());
    all
}

/// Is it said of what stands here that it is along the line of centres, and of nothing that it is across?
pub(super) fn says_along(typed: &str) -> bool {
    let typed = typed.to_lowercase();
    let is_of_centres = |rest: &str| {
        let rest = rest.trim_start().trim_start_matches("the ").trim_start();
        !rest.starts_with(char::is_alphabetic) || rest.starts_with('l')
    };
    let is_along = typed.split("along").skip(1).any(is_of_centres);
    !says_across(&typed) && (is_along || names_line(&typed))
}

/// Is it said of what stands here that it is across the line of centres, or that it stays?
pub(super) fn says_across(typed: &str) -> bool {
    const WORDS: [&str; 8] = ["perp", "across", "tan", "⊥", "unchanged", "no change", "stays", "remains"];
    let typed = typed.to_lowercase();
    WORDS.iter().any(|word| typed.contains(word))
}

/// `line of centres`, `LOC`, `l.o.c.`
fn names_line(typed: &str) -> bool {
    let mut words = typed.split(|sign: char| !sign.is_alphanumeric());
    words.any(|word| word == "loc") || typed.contains("l.o.c") || typed.contains("line of cent")
}
