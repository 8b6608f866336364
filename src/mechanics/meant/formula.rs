//! The formula that a sentence says: for `A turns through 90 degrees`, `A.deflection_deg = 90`.

use crate::expr::{Angles, Expr, read};
use crate::mechanics::Quantity;

/// Words that stand in no formula.
const OF_SENTENCES: [&str; 24] = [
    "the", "of", "is", "are", "as", "out", "through", "not", "be", "must", "should", "and", "or", "to", "with", "when",
    "has", "than", "equals", "no", "whole", "between", "both", "each",
];

/// How a relation is said, and its sign; the longer before what it begins with.
const RELATIONS: [(&str, &str); 33] = [
    ("is not equal to", "!="),
    ("not equal to", "!="),
    ("is different from", "!="),
    ("is not", "!="),
    ("is greater than", ">"),
    ("is more than", ">"),
    ("is larger than", ">"),
    ("greater than", ">"),
    ("more than", ">"),
    ("exceeds", ">"),
    ("is less than", "<"),
    ("is smaller than", "<"),
    ("is below", "<"),
    ("less than", "<"),
    ("is at least", ">="),
    ("at least", ">="),
    ("is at most", "<="),
    ("at most", "<="),
    ("comes out as", "="),
    ("comes to", "="),
    ("is equal to", "="),
    ("equal to", "="),
    ("equals", "="),
    ("must be", "="),
    ("should be", "="),
    ("is", "="),
    ("<=", "<="),
    (">=", ">="),
    ("!=", "!="),
    ("==", "="),
    ("=", "="),
    ("<", "<"),
    (">", ">"),
];

/// What is said of a number in words, the formula for it, and that for its contrary.
const SAID: [(&[&str], &str, &str); 8] = [
    (&["integer", "integers", "whole"], "{} is an integer", "denominator({}) > 1"),
    (&["even"], "{}/2 is an integer", "({} + 1)/2 is an integer"),
    (&["odd"], "({} + 1)/2 is an integer", "{}/2 is an integer"),
    (&["surd", "surds", "irrational"], "radicand({}) > 1", "{} is rational"),
    (&["rational", "fraction"], "{} is rational", "radicand({}) > 1"),
    (&["positive"], "{} > 0", "{} <= 0"),
    (&["negative"], "{} < 0", "{} >= 0"),
    (&["zero", "nought"], "{} = 0", "{} != 0"),
];

/// What is said of two spheres beside each other, and the sign between what they have.
const COMPARED: [(&str, &str, &str); 4] =
    [("heavier", "mass", ">"), ("lighter", "mass", "<"), ("faster", "speed", ">"), ("slower", "speed", "<")];

/// Is a text a sentence, and no formula?
pub fn is_sentence(text: &str) -> bool {
    let words: Vec<&str> = text.split_whitespace().collect();
    let is_known = |word: &&str| word.len() > 1 && Quantity::meant(word).is_some();
    words.iter().any(|word| OF_SENTENCES.contains(&word.to_lowercase().as_str()))
        || words.windows(2).any(|pair| pair.iter().all(is_known))
}

/// The formula that a sentence is perhaps about.
///
/// ```
/// use carom::mechanics::formula_meant;
/// assert_eq!(formula_meant("A turns through 90 degrees").as_deref(), Some("A.deflection_deg = 90"));
/// ```
pub fn formula_meant(sentence: &str) -> Option<String> {
    let text = sentence.trim().trim_end_matches('.').replace("a right angle", "90 degrees");
    // `A is turned through` is `A turns through`, and says nothing that *A* is.
    let text = [" is turned", " is deflected"].iter().fold(text, |text, said| text.replace(said, " turns"));
    let words: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
    let says = |of: &[&str]| words.iter().any(|word| of.contains(&word.as_str()));
    if says(&["different", "unequal", "equal", "same"]) && !says(&["to", "from", "as", "direction"]) {
        let sign = if says(&["different", "unequal"]) { "!=" } else { "=" };
        if says(&["mass", "masses"]) {
            return Some(format!("A.mass {sign} B.mass"));
        }
        let (one, other) = text.split_once(" are ")?.0.split_once(" and ")?;
        return Some(format!("{} {sign} {}", side(one)?, side(other)?));
    }
    let mut spheres = text.split_whitespace().filter(|word| ["A", "B"].contains(word));
    let sphere = spheres.next();
    if let (Some(one), Some(other)) = (sphere, spheres.next())
        && let Some((_, noun, sign)) = COMPARED.iter().find(|(said, ..)| says(&[said]))
    {
        let of = |sphere: &str| side(&format!("{noun} of {sphere} {}", if says(&["before"]) { "before" } else { "" }));
        return Some(format!("{} {sign} {}", of(one)?, of(other)?));
    }
    if let Some(sphere) = sphere.filter(|_| says(&["rest", "stops"])) {
        return Some(format!("{sphere}.after.speed {} 0", if says(&["not", "never"]) { ">" } else { "=" }));
    }
    if let Some(sphere) = sphere.filter(|_| text.contains("goes on") || says(&["continues"])) {
        return Some(format!("{sphere}.after.n {} 0", if sphere == "A" { ">" } else { "<" }));
    }
    if let Some(sphere) = sphere
        && says(&["rebounds", "rebound", "bounces", "reversed", "reverses", "back"])
    {
        // Along the line of centres A comes forwards, and B backwards.
        let is_back = (sphere == "A") != says(&["not", "never"]);
        return Some(format!("{sphere}.after.n {} 0", if is_back { "<" } else { ">" }));
    }
    if says(&["between", "or"]) && text.contains(|sign: char| sign.is_ascii_digit()) {
        return None;
    }
    // `The impulse is a multiple of 3.`
    for divides in ["is a multiple of", "is divisible by"] {
        if let Some((what, by)) = text.split_once(divides) {
            return Some(format!("{}/{} is an integer", side(what)?, side(by)?));
        }
    }
    if let Some((of, said, contrary)) = SAID.iter().find(|(of, ..)| says(of)) {
        let verbs = [" is ", " are ", " must ", " should "].into_iter();
        let word = || of.iter().filter_map(|word| text.find(&format!(" {word}"))).min();
        let end = verbs.filter_map(|verb| text.find(verb)).next().or_else(word).unwrap_or(text.len());
        let what = side(&text[..end]).unwrap_or_else(|| "A.after.speed".to_owned());
        return Some(if says(&["not", "no", "without", "never"]) { contrary } else { said }.replace("{}", &what));
    }
    let padded = format!("{text} ");
    let found = RELATIONS.iter().find_map(|(said, sign)| {
        let at = padded.find(&format!(" {said} "))?;
        Some((at, at + said.len() + 1, *sign))
    });
    if let Some((start, end, sign)) = found {
        // `Prime` is no name.
        let is_word = |text: &str| text.len() > 2 && text.chars().all(|sign| sign.is_ascii_lowercase());
        let right = text[end.min(text.len())..].trim();
        let right = ["a ", "an ", "the "].iter().find_map(|article| right.strip_prefix(article)).unwrap_or(right);
        if is_word(right) && Quantity::meant(&text[end..]).is_none() {
            return None;
        }
        return Some(format!("{} {sign} {}", side(&padded[..start])?, side(&padded[end..])?));
    }
    // `A turns through 90 degrees` ends in its number.
    let number = text.find(|sign: char| sign.is_ascii_digit())?;
    Some(format!("{} = {}", side(&text[..number])?, side(&text[number..])?))
}

/// The formulas that a sentence is perhaps about: of one that says two things, each.
///
/// ```
/// use carom::mechanics::formulas_meant;
/// assert_eq!(formulas_meant("e is between 1/3 and 1/2"), ["e > 1/3", "e < 1/2"]);
/// ```
pub fn formulas_meant(sentence: &str) -> Vec<String> {
    let text = sentence.trim().trim_end_matches('.');
    if let Some((what, (low, high))) =
        text.split_once(" between ").and_then(|(w, ends)| Some((w, ends.split_once(" and ")?)))
    {
        let what = what.trim_end().trim_end_matches(" is").trim_end_matches(" lies");
        let ends = || Some((side(what)?, side(low)?, side(high)?));
        return ends()
            .map_or_else(Vec::new, |(what, low, high)| vec![format!("{what} > {low}"), format!("{what} < {high}")]);
    }
    // Of both it is required of each.
    let of_both = ["speed", "mass"].into_iter().find(|noun| text.contains(&format!("both {noun}")));
    if let Some(noun) = of_both {
        let plural = if text.contains("both masses") { "masses".to_owned() } else { format!("{noun}s") };
        let each = ["A", "B"].map(|sphere| text.replace(&format!("both {plural}"), &format!("the {noun} of {sphere}")));
        return each.iter().filter_map(|each| formula_meant(each)).collect();
    }
    let is_said = |half: &str| RELATIONS.iter().any(|(said, _)| format!("{half} ").contains(&format!(" {said} ")));
    match text.split_once(" and ") {
        Some((one, other)) if is_said(one) && is_said(other) => {
            [one, other].into_iter().filter_map(formula_meant).collect()
        }
        _ => formula_meant(text).into_iter().collect(),
    }
}

/// One side of a relation: a formula as it stands, or the quantity that it names.
fn side(text: &str) -> Option<String> {
    let text = text.trim().trim_start_matches("that ");
    for (word, times) in [("twice ", 2), ("double ", 2), ("half ", 0)] {
        if let Some(rest) = text.strip_prefix(word) {
            let rest = side(rest)?;
            return Some(if times == 0 { format!("{rest}/2") } else { format!("{times}*{rest}") });
        }
    }
    let is_formula = |text: &str| !is_sentence(text) && read(text, Angles::Degrees).is_ok_and(|expr| is_plain(&expr));
    // A number with its unit.
    if let Some((number, unit)) = text.split_once(' ')
        && number.starts_with(|sign: char| sign.is_ascii_digit() || sign == '-')
        && unit.starts_with(char::is_alphabetic)
        && is_formula(number)
    {
        return Some(number.to_owned());
    }
    if is_formula(text) {
        return Some(text.to_owned());
    }
    Quantity::meant(text).map(|quantity| quantity.to_string())
}

/// Has it no product of names that stand side by side, as words do?
fn is_plain(expr: &Expr) -> bool {
    !matches!(expr, Expr::Relation(..))
        && expr.names().iter().all(|name| !["A", "B", "C"].contains(&name.text.as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_means_a_formula_that_can_be_read() {
        let table = [
            ("A turns through 90 degrees", "A.deflection_deg = 90"),
            ("A turns through a right angle", "A.deflection_deg = 90"),
            ("the speed of A after is an integer", "A.after.speed is an integer"),
            ("speed of B after is whole", "B.after.speed is an integer"),
            ("e comes out as 5/7", "e = 5/7"),
            ("A.deflection_deg is 90", "A.deflection_deg = 90"),
            ("mA not equal to mB", "mA != mB"),
            ("the masses are different", "A.mass != B.mass"),
            ("A rebounds", "A.after.n < 0"),
            ("A does not rebound", "A.after.n > 0"),
            ("mA and mB are different", "mA != mB"),
            ("no surds", "A.after.speed is rational"),
            ("the speed of B is a surd", "radicand(B.after.speed) > 1"),
            ("the speed of B has no surd", "B.after.speed is rational"),
            ("the speed of A without surds", "A.after.speed is rational"),
            ("A.deflection_deg between 30 and 60", ""),
            ("A is turned through a right angle", "A.deflection_deg = 90"),
            ("A is deflected through 30 degrees", "A.deflection_deg = 30"),
            ("A is deflected by more than 20 degrees", "A.deflection_deg > 20"),
            ("A.after.speed integer", "A.after.speed is an integer"),
            ("A.after.speed is not an integer", "denominator(A.after.speed) > 1"),
            ("ke.lost is not zero", "ke.lost != 0"),
            ("mA is even", "mA/2 is an integer"),
            ("the impulse is a multiple of 3", "impulse.magnitude/3 is an integer"),
            ("A comes to rest", "A.after.speed = 0"),
            ("A is faster than B after", "A.after.speed > B.after.speed"),
            ("B is heavier than A", "B.mass > A.mass"),
            ("A goes on in the same direction", "A.after.n > 0"),
            ("A.after.speed = 3 or A.after.speed = 4", ""),
            ("the speed of A is equal to the speed of B", "A.after.speed = B.after.speed"),
            ("the direction of B is reversed", "B.after.n > 0"),
            ("speed of B after = 3", "B.after.speed = 3"),
            ("the speed of A is less than the speed of B", "A.after.speed < B.after.speed"),
            ("the mass of A is twice the mass of B", "A.mass = 2*B.mass"),
            ("kinetic energy lost is at most 12 J", "ke.lost <= 12"),
            ("no surd in the speed of A", "A.after.speed is rational"),
            ("the deflection of A is positive", "A.deflection_deg > 0"),
            ("A.after.speed whole", "A.after.speed is an integer"),
        ];
        let meant = |sentence| formula_meant(sentence).unwrap_or_default();
        let wrong: Vec<_> = table.iter().filter(|(sentence, formula)| meant(sentence) != *formula).collect();
        let found: Vec<_> = wrong.iter().map(|(sentence, _)| (sentence, meant(sentence))).collect();
        assert!(wrong.is_empty(), "{found:?}");
        let all = [
            ("the deflection of A is between 30 and 60 degrees", "A.deflection_deg > 30, A.deflection_deg < 60"),
            ("A.after.speed > 3 and A.after.speed < 6", "A.after.speed > 3, A.after.speed < 6"),
            ("mA and mB are different", "mA != mB"),
            ("both speeds are integers", "A.after.speed is an integer, B.after.speed is an integer"),
            ("both masses are even", "A.mass/2 is an integer, B.mass/2 is an integer"),
        ];
        for (sentence, formulas) in all {
            assert_eq!(formulas_meant(sentence).join(", "), formulas);
        }
        for formula in
            ["mA != mB", "A.after.n > 0", "u speed > 3", "2 m cos(alpha) < 3", "denominator(p/q) = q", "before != 1"]
        {
            assert!(!is_sentence(formula), "{formula}");
        }
    }
}
