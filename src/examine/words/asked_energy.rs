//! Do the words ask for the energy that is found: what is lost, of one sphere or of both, and not what is left?

use super::impacts::impacts;
use super::sentence::{Sentence, Token, is_one_of, says, sentences};
use crate::answer::Kind;
use crate::bank::{Answer, Find, Part, Question};
use crate::examine::Finding;
use crate::expr::print;
use crate::mechanics::{Moment, Quantity, Sphere};

/// The words ask for the energy that both lose, and the answer is what one does, or the other way round.
pub fn energy_of_another(question: &Question, answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    let quantity = *answer.find.quantities().first()?;
    let impacts = impacts(&question.scene);
    let is_of_one = impacts.iter().any(|impact| impact.number == quantity.impact() && impact.is_of_one());
    if is_of_one || answer.kind == Kind::Shown {
        return None;
    }
    let mut named: Vec<Sphere> = Vec::new();
    for token in asked.iter().flatten() {
        if let Token::Sphere(sphere) = token
            && !named.contains(sphere)
        {
            named.push(*sphere);
        }
    }
    let is_lost_by = asked.iter().flat_map(|sentence| sentence.windows(3)).any(|words| match words {
        [lost, by, Token::Sphere(_)] => is_one_of(lost, &["lost"]) && is_one_of(by, &["by"]),
        [that, Token::Sphere(_), loses] => {
            (is_one_of(that, &["that"]) && is_one_of(loses, &["loses"]))
                || (is_one_of(that, &["does"]) && is_one_of(loses, &["lose"]))
        }
        _ => false,
    });
    // `The loss in the kinetic energy of sphere *A*`
    let is_of_one = |words: &[Token]| {
        let named = words.iter().find(|token| !is_one_of(token, &["the", "sphere", "ball"]));
        matches!(named, Some(Token::Sphere(_)))
    };
    let is_energy_of = asked.iter().any(|sentence| {
        let mut ends = sentence
            .windows(2)
            .enumerate()
            .filter(|(_, pair)| is_one_of(&pair[0], &["energy"]) && is_one_of(&pair[1], &["of"]));
        says(sentence, &["lost", "loss", "reduction", "decrease"]) && ends.any(|(at, _)| is_of_one(&sentence[at + 2..]))
    });
    let name = print::text_unicode(&answer.name);
    let found = |asks: &str, has: &str| {
        Finding::new(format!("the words ask for {asks}, and the answer `{name}` is {has}"), "", "another energy")
    };
    let (all, what) = ("all that is lost", |sphere: Sphere| format!("what *{}* loses", sphere.name()));
    match (quantity.of_its_impact(), named.as_slice()) {
        // The one that loses it may be described, and not named.
        (Quantity::SphereEnergyLost(own), []) => Some(found(all, &what(own)).as_warning()),
        (Quantity::EnergyLost | Quantity::FractionLost, [one]) if is_lost_by || is_energy_of => {
            Some(found(&what(*one), all))
        }
        _ => None,
    }
}

/// The words ask for what is lost in several impacts, and the answer is what one of them loses.
pub fn of_several_impacts(question: &Question, answer: &Answer, asked: &[Sentence]) -> Option<Finding> {
    let quantity = *answer.find.quantities().first()?;
    let is_loss = matches!(quantity.of_its_impact(), Quantity::EnergyLost | Quantity::SphereEnergyLost(_));
    let is_of_all = |sentence: &Sentence| {
        says(sentence, &["energy"])
            && says(sentence, &["total", "two", "both", "three", "all", "altogether"])
            && says(sentence, &["collisions", "impacts", "walls"])
            && !says(sentence, &["first", "second", "third", "each", "between"])
    };
    if question.scene.then.is_empty() || !is_loss || !asked.iter().any(is_of_all) {
        return None;
    }
    let name = print::text_unicode(&answer.name);
    let message =
        format!("the words ask for what several impacts lose, and the answer `{name}` is what one of them does");
    let help = "ask for the loss of one impact, or for each by itself: `ke.lost` is of the first, `second.ke.lost` of the second";
    Some(Finding::new(message, "", "of one impact").with_help(help))
}

/// The words ask for what is lost, and the answer is what there is before the impact or after it.
pub fn energy_at_a_moment(answer: &Answer, part: &Part, asked: &[Sentence]) -> Option<Finding> {
    const LOST: [&str; 7] = ["lost", "loss", "losses", "lose", "loses", "reduction", "decrease"];
    let Find::Quantity(quantity) = answer.find else { return None };
    let (moment, lost) = match quantity.of_its_impact() {
        Quantity::TotalEnergy(moment) => (moment, Quantity::EnergyLost),
        Quantity::KineticEnergy(sphere, moment) => (moment, Quantity::SphereEnergyLost(sphere)),
        _ => return None,
    };
    let word =
        asked.iter().filter(|sentence| says(sentence, &["energy"])).flatten().find(|token| is_one_of(token, &LOST));
    let Some(Token::Word(word)) = word.filter(|_| part.answers.len() == 1 && answer.kind != Kind::Shown) else {
        return None;
    };
    let when = if moment == Moment::Before { "before" } else { "after" };
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for what is `{word}`, and the answer `{name}` is an energy {when} the impact");
    let lost = lost.in_impact(quantity.impact())?;
    Some(Finding::new(message, "", "found here").with_help(format!("find `{lost}`, or ask for the energy {when}")))
}

/// Is an energy the very thing that a sentence asks for: `find the total kinetic energy`?
fn asks_at_once(sentence: &[Token]) -> bool {
    const DESCRIBED: [&str; 5] = ["the", "total", "kinetic", "combined", "their"];
    const ASKING: [&str; 6] = ["find", "calculate", "determine", "state", "obtain", "what"];
    let leads = |at: usize| sentence[..at].iter().rev().find(|token| !is_one_of(token, &DESCRIBED));
    let is_energy = |at: &usize| is_one_of(&sentence[*at], &["energy", "energies"]);
    (0..sentence.len()).filter(is_energy).any(|at| match leads(at) {
        Some(lead) => *lead == Token::Comma || is_one_of(lead, &ASKING),
        None => false,
    })
}

/// Do the words ask for a percentage, and name neither a fraction nor the sign to be written?
fn asks_for_hundredths(part: &Part, asked: &[Sentence]) -> bool {
    let words = |list: &[&str]| asked.iter().any(|sentence| says(sentence, list));
    let has_sign = part.ask.iter().any(|text| print::text_unicode(text).contains('%'));
    words(&["percentage", "percent", "cent"]) && !words(&["fraction", "proportion", "sign"]) && !has_sign
}

/// The words ask for a percentage, of which a student may leave the sign out.
fn in_hundredths(answer: &Answer) -> Finding {
    let name = print::text_unicode(&answer.name);
    let message = format!("the words ask for a percentage, and the answer `{name}` is a fraction of one");
    let help =
        "ask for the fraction that is lost, of which `25%` is accepted too; or for the percentage with its sign, %";
    Finding::new(message, "", "a student who writes 25 for 25% is marked wrong").with_help(help)
}

/// The words, or the name of the answer, speak of what is gained or left, or of a fraction, or of no loss at all, and the
/// answer is what is lost; or the reverse.
pub fn other_energy(answer: &Answer, part: &Part, asked: &[Sentence]) -> Option<Finding> {
    const LOST: [&str; 19] = [
        "lost",
        "loss",
        "losses",
        "lose",
        "loses",
        "losing",
        "decrease",
        "decreases",
        "reduction",
        "reduced",
        "change",
        "changes",
        "difference",
        "dissipated",
        "converted",
        "turned",
        "absorbed",
        "cost",
        "costs",
    ];
    const GAINED: [&str; 9] =
        ["gained", "gain", "gains", "gaining", "increase", "increases", "change", "changes", "difference"];
    const KEPT: [&str; 5] = ["remaining", "remains", "left", "retained", "kept"];
    const PART: [&str; 6] = ["fraction", "proportion", "percentage", "ratio", "share", "part"];
    let Find::Quantity(quantity) = answer.find else { return None };
    let (is_fraction, gained) = match quantity.of_its_impact() {
        Quantity::EnergyLost => (false, None),
        Quantity::SphereEnergyLost(sphere) => (false, Some(Quantity::SphereEnergyGained(sphere))),
        Quantity::SphereEnergyGained(_) => (false, None),
        Quantity::FractionLost => (true, None),
        _ => return None,
    };
    let is_gain = matches!(quantity.of_its_impact(), Quantity::SphereEnergyGained(_));
    // What is said of both is no sign of the opposite.
    let opposite = |words: &'static [&'static str], own: &[&str]| -> Vec<&'static str> {
        words.iter().chain(&KEPT).filter(|word| !own.contains(word)).copied().collect()
    };
    let (own, others, has) = match is_gain {
        true => (&GAINED[..], opposite(&LOST, &GAINED), "is what is gained"),
        false => (&LOST[..], opposite(&GAINED, &LOST), "is what is lost"),
    };
    if matches!(answer.kind, Kind::Shown | Kind::Range) {
        return None;
    }
    // Who asks for what is lost and for the fraction that it is has an answer to each.
    let is_other = |other: &Answer| match other.find {
        Find::Quantity(other) => match other.of_its_impact() {
            Quantity::EnergyLost => is_fraction,
            Quantity::FractionLost => !is_fraction,
            _ => false,
        },
        _ => false,
    };
    if part.answers.iter().any(is_other) {
        return None;
    }
    let name = sentences(&answer.name);
    let is_energy = asked.iter().any(|sentence| says(sentence, &["energy", "energies"]));
    // The name of an answer may be right where the words are not.
    let other = [asked, &name].into_iter().find_map(|words| {
        let speaks = !words.iter().any(|sentence| says(sentence, own));
        words.iter().flatten().find(|token| speaks && is_one_of(token, &others))
    });
    let is_lost = asked.iter().any(|sentence| says(sentence, own));
    if other.is_none() && is_fraction && asks_for_hundredths(part, asked) {
        return Some(in_hundredths(answer));
    }
    let shown = print::text_unicode(&answer.name);
    let said = asked.iter().any(|sentence| says(sentence, &PART));
    let (asks, has) = match (other, is_fraction) {
        (Some(Token::Word(word)), _) => (format!("what is `{word}`"), has),
        (_, true) if is_energy && !said => ("an energy".to_owned(), "is a fraction of one"),
        (_, false) if asked.iter().any(|words| says(words, &["fraction", "percentage", "proportion"])) => {
            ("a fraction".to_owned(), "is the energy itself")
        }
        _ if is_energy && !is_lost && is_gain => ("a kinetic energy".to_owned(), "is what is gained of it"),
        _ if is_energy && !is_lost => ("a kinetic energy".to_owned(), "is what is lost of it"),
        _ => return None,
    };
    let found = Finding::new(format!("the words ask for {asks}, and the answer `{shown}` {has}"), "", "found here");
    let is_gain_asked = matches!(other, Some(Token::Word(word)) if GAINED.contains(&word.as_str()));
    let found = match gained.and_then(|gained| gained.in_impact(quantity.impact())).filter(|_| is_gain_asked) {
        Some(gained) => found.with_help(format!("find `{gained}`, or ask for what is lost")),
        None => found,
    };
    // A loss has more words than are known here: `the amount by which it diminishes the energy`.
    let may_be_lost = other.is_none() && !is_lost && !asked.iter().any(|sentence| asks_at_once(sentence));
    Some(if may_be_lost { found.as_warning() } else { found })
}
