//! What the text and the note of a mark say of its value: which thing it is, how large, how accurate, and whether an earlier
//! value can be followed to it.

use super::figures;
use super::requests::{Thing, thing};
use super::sentence::{Sentence, Token, is_one_of, says, sentences};
use super::typed::quantities;
use crate::answer::Accept;
use crate::bank::{Code, EarnedFor, Find, Mark, Part, Question};
use crate::examine::Finding;
use crate::expr::{Text, print};
use crate::mechanics::{Moment, Quantity, Sphere, VelocityText};
use crate::number::Places;

/// Marks whose words are of another value than the one they are for.
pub fn of_another_value(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    let mut is_value_before = false;
    for (place, part) in question.parts.iter().enumerate() {
        for (row, mark) in part.marks.iter().enumerate() {
            let found = of_another_thing(mark)
                .or_else(|| sum_of_energies(part, mark))
                .or_else(|| typed(mark))
                .or_else(|| given(question, mark))
                .or_else(|| other_figures(question, part, mark))
                .or_else(|| other_sign(question, mark))
                .or_else(|| nothing_to_follow(mark, is_value_before));
            findings.extend(found.map(|found| found.at_row(place, "marks", row).as_warning()));
            let is_value = matches!(mark.earned_for, EarnedFor::Quantity(_) | EarnedFor::Unknown(_));
            is_value_before |= is_value || mark.code.is_accuracy();
        }
    }
    findings
}

/// `Kinetic energy lost`, for a speed.
fn of_another_thing(mark: &Mark) -> Option<Finding> {
    let EarnedFor::Quantity(quantity) = mark.earned_for else { return None };
    // `From their speeds`, `ratio of components`: what it is found from.
    const MEANS: [&str; 14] = [
        "from", "ft", "their", "using", "uses", "use", "ratio", "over", "times", "by", "correct", "both", "all",
        "inverse",
    ];
    let words = sentences(mark.text.as_ref()?);
    let said = words
        .iter()
        .flat_map(|sentence| sentence.iter().take_while(|token| **token != Token::Comma && !is_one_of(token, &MEANS)));
    let named: Vec<_> = said.filter_map(|token| Some((token, thing(token)?))).collect();
    // An impulse is a mass times a change of velocity, and e one speed over another.
    let is_made_of = |thing: Thing| match quantity.of_its_impact() {
        Quantity::Impulse(..) | Quantity::ImpulseMagnitude => {
            matches!(thing, Thing::Mass | Thing::Velocity | Thing::Momentum)
        }
        Quantity::Restitution => matches!(thing, Thing::Speed | Thing::Velocity | Thing::Ratio | Thing::Share),
        _ => false,
    };
    if named.iter().any(|(_, thing)| thing.is(quantity) || is_made_of(*thing)) {
        return None;
    }
    let (Token::Word(noun), _) = named.first()? else { return None };
    let message = format!("the text of the mark {} speaks of `{noun}`, and it is for `{quantity}`", mark.id);
    let help = "say in its `text` what it is for, or mend `for`";
    Some(Finding::new(message, "", "for another value").with_help(help))
}

/// `Sum of the kinetic energies`, where what is lost of them is found: a difference.
fn sum_of_energies(part: &Part, mark: &Mark) -> Option<Finding> {
    const LOST: [&str; 18] = [
        "lost",
        "loss",
        "lose",
        "loses",
        "losses",
        "gain",
        "gains",
        "gained",
        "change",
        "changes",
        "difference",
        "less",
        "minus",
        "subtract",
        "subtracts",
        "subtracted",
        "before",
        "initial",
    ];
    let is_lost =
        |quantity: &Quantity| matches!(quantity.of_its_impact(), Quantity::EnergyLost | Quantity::SphereEnergyLost(_));
    let is_for_loss = match &mark.earned_for {
        EarnedFor::Quantity(quantity) => is_lost(quantity),
        EarnedFor::Law(law, _) => {
            law.gives(Quantity::EnergyLost)
                && part.answers.iter().flat_map(|answer| answer.find.quantities()).any(|found| is_lost(&found))
        }
        _ => false,
    };
    let text = mark.text.as_ref().filter(|_| is_for_loss)?;
    let words = sentences(text);
    let adds = |sentence: &Sentence| {
        let sum = sentence.iter().position(|token| is_one_of(token, &["sum", "add", "adds", "total"]));
        sum.is_some_and(|sum| says(&sentence[sum..], &["energy", "energies", "ke"]))
    };
    let signs = print::text_unicode(text).contains(['−', '-', '–']);
    if signs || !words.iter().any(adds) || words.iter().any(|sentence| says(sentence, &LOST)) {
        return None;
    }
    let message = format!("the text of the mark {} adds kinetic energies up, and what is lost is found", mark.id);
    let help = "say `difference of the kinetic energies` in its `text`, or mend `for`";
    Some(Finding::new(message, "", "for what is lost").with_help(help))
}

/// A value that stands in the scene, and that nobody has to find.
fn given(question: &Question, mark: &Mark) -> Option<Finding> {
    let EarnedFor::Quantity(quantity) = mark.earned_for else { return None };
    let scene = &question.scene;
    let of = |sphere: Sphere| match sphere {
        Sphere::A => (scene.before.a.as_ref(), scene.masses.a.as_ref()),
        _ => (scene.before.b.as_ref(), scene.masses.b.as_ref()),
    };
    let is_found = |text: &String| scene.unknowns.iter().any(|unknown| text.contains(unknown));
    let is_given = match quantity {
        Quantity::Speed(sphere, Moment::Before) => match of(sphere).0 {
            Some(VelocityText::Polar(polar)) => !is_found(&polar.speed),
            Some(VelocityText::Components([x, y])) => x == "0" && y == "0",
            _ => false,
        },
        Quantity::Mass(sphere) => of(sphere).1.is_some_and(|mass| !is_found(mass)),
        Quantity::Restitution => scene.e.as_ref().is_some_and(|e| !is_found(e)),
        _ => false,
    };
    let message = format!("the mark {} is for `{quantity}`, which is given", mark.id);
    is_given
        .then(|| Finding::new(message, "", "nobody has to find it").with_help("name what has to be found with `for`"))
}

/// `7.5 J`, `awrt 46.1`: right in one variant alone.
fn typed(mark: &Mark) -> Option<Finding> {
    let texts = mark.text.iter().chain(&mark.note);
    let shown = texts.into_iter().find_map(|text| {
        let with_unit = quantities(text).into_iter().next().map(|typed| typed.shown);
        with_unit.or_else(|| rounded(text))
    })?;
    let message = format!("the mark {} gives `{shown}` in plain digits, which is right in one variant alone", mark.id);
    let help = "take it out: the scheme prints the value of each variant; or write a formula in braces";
    Some(Finding::new(message, shown, "the same in every variant").with_help(help))
}

/// `Awrt 46.1`, and not `awrt 3 s.f.`
fn rounded(text: &Text) -> Option<String> {
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    sentences(text).iter().find_map(|sentence| {
        sentence.windows(2).enumerate().find_map(|(place, pair)| match pair {
            [awrt, Token::Word(number)] if is_one_of(awrt, &["awrt"]) && is_number(number) => {
                figures::asked(&sentence[place + 1..]).is_empty().then(|| format!("awrt {number}"))
            }
            _ => None,
        })
    })
}

/// `Awrt 2 s.f.`, where the answer is accepted to three.
fn other_figures(question: &Question, part: &Part, mark: &Mark) -> Option<Finding> {
    let is_for = |find: &Find| match &mark.earned_for {
        EarnedFor::Quantity(quantity) => find.quantities().contains(quantity),
        EarnedFor::Unknown(name) => *find == Find::Unknown(name.clone()),
        _ => false,
    };
    let answer = part.answers.iter().find(|answer| is_for(&answer.find))?;
    let own: Vec<&Places> = question.styles.iter().filter_map(|style| answer.accept(style.name).places()).collect();
    let texts = mark.text.iter().chain(&mark.note);
    // `A0 if 2 s.f.`
    let is_denied = |sentence: &Sentence| says(sentence, &["a0", "not", "if", "no"]);
    let wanted = texts.flat_map(sentences).filter(|sentence| !is_denied(sentence));
    let asked = wanted.into_iter().find_map(|sentence| figures::asked(&sentence).into_iter().next())?;
    let own = own.first().filter(|_| !own.contains(&&asked))?;
    let [asked, own] = [asked, (*own).clone()].map(Accept::Rounded);
    let message = format!("the mark {} is given for `{asked}`, and the answer is accepted to `{own}`", mark.id);
    Some(Finding::new(message, "", "another accuracy").with_help("say the same here and in `accept`"))
}

/// `Velocity of A positive`, where the condition has it negative.
fn other_sign(question: &Question, mark: &Mark) -> Option<Finding> {
    let (EarnedFor::Condition, [condition]) = (&mark.earned_for, question.scene.conditions.as_slice()) else {
        return None;
    };
    let (left, right) = condition.split_once(['<', '>'])?;
    let is_of_sign = left.trim().parse::<Quantity>().is_ok() && right.trim_start_matches('=').trim() == "0";
    let (own, other) = if condition.contains('<') { ("negative", "positive") } else { ("positive", "negative") };
    let words = sentences(mark.text.as_ref()?);
    let says = |word: &str| words.iter().any(|sentence| says(sentence, &[word]));
    // `Their v < 0, with the original direction positive`
    let text = print::text_unicode(mark.text.as_ref()?);
    let is_of_convention = text.contains(['<', '>']) || ["direction", "taken", "right"].into_iter().any(says);
    if !is_of_sign || !says(other) || says(own) || says("not") || is_of_convention {
        return None;
    }
    let message = format!("the text of the mark {} says `{other}`, and the condition is `{condition}`", mark.id);
    Some(Finding::new(message, "", "of the other sign").with_help(format!("say `{own}`, or mend the condition")))
}

/// A mark that follows an earlier value, before which no value is found.
fn nothing_to_follow(mark: &Mark, is_value_before: bool) -> Option<Finding> {
    if mark.code != Code::A1FollowThrough || is_value_before {
        return None;
    }
    let message = format!("the mark {} follows an earlier value, and none is found before it", mark.id);
    Some(
        Finding::new(message, "", "nothing to follow")
            .with_help("write `A1`, or put it behind the value that it follows"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examine::{Edits, edited};

    #[test]
    fn the_words_of_a_mark_are_of_its_value() {
        let (line, rest) = ("direct/one-sphere-catches-the-other", "rest/speeds-and-directions");
        let lost = "{ code = \"A1\", for = \"ke.lost\" }";
        let with = |more: &str| format!("{{ code = \"A1\", for = \"ke.lost\", {more} }}");
        let texts = [
            ("text = \"speed after\"", "speaks of `speed`, and it is for `ke.lost`"),
            ("text = \"loss of kinetic energy\"", ""),
            ("text = \"sum of the kinetic energies\"", "adds kinetic energies up"),
            ("text = \"total kinetic energy before less that after\"", ""),
            ("text = \"sum of the losses of kinetic energy\"", ""),
            ("text = \"total kinetic energy lost\"", ""),
            ("text = \"KE lost, ft their speeds\"", ""),
            ("text = \"from their speeds\"", ""),
            ("note = \"awrt 3sf; A0 if 2 sf\"", ""),
            ("text = \"7.5 J\"", "gives `7.5 J` in plain digits"),
            ("note = \"accept 7.5 J only\"", "gives `7.5 J` in plain digits"),
            ("note = \"awrt 46.1\"", "gives `awrt 46.1` in plain digits"),
            ("note = \"awrt 2sf\"", "is given for `2sf`, and the answer is accepted to `3sf`"),
            ("note = \"awrt 3 s.f.\"", ""),
        ];
        for (more, words) in texts {
            let to = with(more);
            let edits: Edits = &[(lost, &to)];
            let said: String = of_another_value(&edited(line, edits)).into_iter().map(|found| found.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{more}: {said}");
        }
        let table: [(&str, Edits, &str); 7] = [
            (rest, &[], ""),
            (
                rest,
                &[("\"B1\", for = \"perpendicular\"", "\"B1\", for = \"B.before.speed\"")],
                "`B.before.speed`, which is given",
            ),
            (rest, &[("\"B1\", for = \"perpendicular\"", "\"B1\", for = \"e\"")], "for `e`, which is given"),
            (rest, &[("\"A1\", for = \"momentum\"", "\"A1ft\", for = \"momentum\"")], "none is found before it"),
            ("ranges/direction-reversed", &[], ""),
            (
                "ranges/direction-reversed",
                &[("velocity of *A* negative", "*v* < 0, with the original direction positive")],
                "",
            ),
            (
                "ranges/direction-reversed",
                &[("velocity of *A* negative", "velocity of *A* positive")],
                "says `positive`",
            ),
        ];
        for (id, edits, words) in table {
            let said: String = of_another_value(&edited(id, edits)).into_iter().map(|found| found.message).collect();
            assert!(said.contains(words) && said.is_empty() == words.is_empty(), "{id}: {edits:?}: {said}");
        }
    }
}
