//! What a student calls a value: a right value under the name of another sphere or another quantity is for a person.
//!
//! A letter of the student's own (`x`, `k`, `s`) names nothing in particular. What the subject has names for does: words such as
//! `impulse` and `deflection`, u, v and w for velocities, m for a mass, I or J for an impulse, E for an energy, e for the
//! coefficient of restitution, Greek letters for angles. A letter that the question gives is the name of what it gives.

use crate::answer::Kind;
use crate::expr::Expr;
use crate::mark::reading::{Form, Label, Said, Statement, is_strange};
use crate::mechanics::{Axis, Moment, Quantity, Sphere};

use super::changes::{is_change, is_opposite, is_turned_round};
use super::finding::Finding;
use super::letters::of_letter;
use super::moments::{self, AT_THE_END, states};
use super::multiplied::is_multiplied;
use super::otherwise::{is_another_of_its_sort, is_changed_to, remark_names_another};
use super::sorts::{Sort, changes_in_words, is_of_change, sort, suits, words};
use super::spheres::{self, named_sphere, sphere};
use super::{Model, Note, besides, letters, quotients, sides};

/// What was found of a value, if it is called what is asked for.
pub(super) fn as_called(model: &Model, statement: &Statement, finding: Finding) -> Finding {
    let is_of_one = model.quantity.is_some_and(|asked| sphere(asked).is_some());
    if finding.is_credited() && is_of_one && spheres::is_of_several(statement) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let Some(label) = statement.label.as_ref() else { return finding };
    if model.quantity.is_some_and(|asked| quotients::is_upside_down(&label.typed, asked))
        && (finding.is_credited() || finding.note == Some(Note::Inverted))
    {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    if !finding.is_credited() {
        return finding;
    }
    if label.expr.is_none() && spheres::words_without_commands(&label.typed).any(is_strange) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let Some(asked) = model.quantity else {
        let is_of_sphere = model.letter.is_some() && matches!(label.typed.trim(), "A" | "B" | "C" | "P" | "Q");
        if is_of_sphere {
            return Finding::unreadable(Note::NamedOtherwise);
        }
        let is_else =
            |sort: Sort| sort.is_unasked() || label.expr.is_none() && letters::is_for_another_letter(model, sort);
        let is_unasked = words(&label.typed).filter_map(sort).any(is_else);
        return if is_unasked { Finding::unreadable(Note::NamedOtherwise) } else { finding };
    };
    let others = named_sphere(statement).is_some_and(|named| match sphere(asked) {
        Some(asked) => named != asked,
        None => model.is_of_both || spheres::takes_two(asked) || model.strangers.contains(&named),
    });
    if finding.is_credited() && quotients::is_another(&label.typed, asked) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    // `speed of separation/speed of approach` is neither of the two.
    let is_ratio = label.typed.contains('/') || words(&label.typed).any(|word| word.eq_ignore_ascii_case("ratio"));
    let sorts: Vec<Sort> = words(&label.typed).filter_map(sort).filter(|_| !is_ratio).collect();
    // `angle of deflection` is no other angle.
    let is_special = |sort: &&Sort| matches!(sort, Sort::Deflection | Sort::Bearing);
    let is_else = sorts.iter().find(is_special).is_some_and(|sort| !suits(asked, *sort));
    if others
        || is_else
        || is_of_other_sphere(asked, &label.typed)
        || is_of_another_angle(asked, label)
        || !(sorts.is_empty() || sorts.iter().any(|sort| suits(asked, *sort)))
    {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let is_loss = is_of_change(asked);
    if is_loss && is_turned_round(asked, &label.typed) && finding.note != Some(Note::ChangeNotLoss) {
        return finding.at_most_partial(Note::Sign);
    }
    finding
}

/// Is a value called what is asked for, by a name that the subject has for it? A letter of the student's own is none, nor
/// is what names a part of it.
pub(in crate::mark) fn is_named(model: &Model, statement: &Statement) -> bool {
    let Some(label) = &statement.label else { return false };
    if matches!(model.kind, Kind::Vector | Kind::Velocity | Kind::Line) {
        return true;
    }
    let Some(asked) = model.quantity else { return false };
    let spheres = (sphere(asked), named_sphere(statement));
    if is_of_a_part(&label.typed, asked) || spheres.1.is_some_and(|named| spheres.0 != Some(named)) {
        return false;
    }
    let has = |wanted: &[&str]| words(&label.typed).any(|word| wanted.contains(&word.to_lowercase().as_str()));
    let is_sort = || words(&label.typed).filter_map(sort).any(|sort| suits(asked, sort));
    let letter = match &label.expr {
        Some(Expr::Name(name)) => name.text.as_str(),
        _ => "",
    };
    let is_own_letter = || !model.vocabulary.letters.iter().any(|own| own.name() == letter);
    match asked.of_its_impact() {
        Quantity::Speed(..) | Quantity::Velocity(..) => {
            is_sort() || (spheres.1.is_some() && letter.starts_with(['v', 'V']))
        }
        Quantity::EnergyLost | Quantity::SphereEnergyLost(_) => {
            has(&["lost", "loss", "loses", "change", "decrease"])
                || label.typed.contains(['Δ', '∆'])
                || (letter == "L" && is_own_letter())
        }
        Quantity::SphereEnergyGained(_) => {
            has(&["gain", "gains", "gained", "change", "increase"]) || label.typed.contains(['Δ', '∆'])
        }
        Quantity::FractionLost => has(&["fraction", "proportion", "lost", "loss"]),
        Quantity::TanDeflection(_) | Quantity::TanToLine(..) => label.typed.starts_with("tan") || is_sort(),
        _ if asked.is_angle() => {
            is_sort() || (["theta", "phi", "alpha", "beta", "gamma", "delta"].contains(&letter) && is_own_letter())
        }
        Quantity::Mass(_) => {
            // `M` beside the question's `m` is the other mass.
            let is_other = || label.typed.trim() == "M" && model.vocabulary.letters.iter().any(|own| own.name() == "m");
            is_sort() || is_other() || (spheres.1.is_some() && letter.starts_with(['m', 'M']))
        }
        Quantity::Impulse(..) | Quantity::ImpulseMagnitude | Quantity::Restitution => is_sort(),
        Quantity::KineticEnergy(..) | Quantity::TotalEnergy(_) => is_sort(),
        _ => false,
    }
}

/// `30 J lost`, where the loss is asked.
pub(super) fn is_said_to_be_lost(model: &Model, statement: &Statement) -> bool {
    let mut remarks = statement.remarks().flat_map(|remark| words(remark));
    let asked = model.quantity.filter(|asked| is_of_change(*asked));
    asked.is_some_and(|asked| remarks.any(|word| changes_in_words(asked).contains(&word)))
}

/// May a value be this quantity by the name that a line gives it? A letter of the student's own may be anything, and so may
/// a formula, `e × 5`.
pub(in crate::mark) fn may_be_named(label: &str, asked: Quantity) -> bool {
    if label.contains(['+', '-', '−', '*', '×', '·', '/', '^', '²']) {
        return true;
    }
    let asked = asked.of_its_impact();
    let is_velocity = of_letter(label.trim()) == Some(Sort::Speed);
    let mut sorts = words(label).filter_map(sort).chain(is_velocity.then_some(Sort::Velocity)).peekable();
    sorts.peek().is_none() || sorts.any(|sort| suits(asked, sort))
}

/// Is a value called by the word for something else: `speed`, where an angle is asked?
pub(super) fn is_word_for_another(model: &Model, label: &Label) -> bool {
    if label.expr.is_some() {
        return false;
    }
    let mut sorts = words(&label.typed).filter_map(sort).peekable();
    let is_known = model.quantity.is_some() || model.letter.is_some();
    let is_own = |sort: Sort| match model.quantity {
        Some(asked) => suits(asked, sort),
        None => !letters::is_for_another_letter(model, sort),
    };
    is_known && sorts.peek().is_some() && !sorts.any(is_own)
}

/// Does a label speak of a component, or of another moment, where that is not what is asked?
pub(in crate::mark) fn is_of_a_part(label: &str, asked: Quantity) -> bool {
    const COMPONENT: [&str; 14] = [
        "component",
        "components",
        "comp",
        "comps",
        "cpt",
        "perpendicular",
        "perp",
        "parallel",
        "para",
        "along",
        "i",
        "j",
        "x",
        "y",
    ];
    const BEFORE: [&str; 4] = ["before", "initial", "initially", "original"];
    let asked = asked.of_its_impact();
    let is_whole = matches!(asked, Quantity::Speed(..));
    let is_after = matches!(asked, Quantity::Speed(_, Moment::After) | Quantity::Velocity(_, Moment::After, _))
        || matches!(asked, Quantity::KineticEnergy(_, Moment::After) | Quantity::TotalEnergy(Moment::After))
        || matches!(asked, Quantity::EnergyLost | Quantity::SphereEnergyLost(_) | Quantity::SphereEnergyGained(_));
    let several = words(label).count() > 1;
    words(label).map(str::to_lowercase).any(|word| {
        let is = |list: &[&str]| list.contains(&word.as_str());
        // `along` alone may be said of a sphere that moves so.
        let is_part = is(&COMPONENT) && (several || matches!(&*word, "perp" | "perpendicular"));
        (is_whole && is_part) || (is_after && is(&BEFORE) && !label.contains("after"))
    })
}

/// Words for an angle that is not the one to a line of centres.
const OTHER_ANGLES: [&str; 4] = ["perpendicular", "perp", "change", "changes"];

/// `perpendicular: 46.1°`, `change of direction 46.1°`
fn is_of_another_angle(asked: Quantity, label: &Label) -> bool {
    matches!(asked, Quantity::AngleToLine(..))
        && label.expr.is_none()
        && words(&label.typed).any(|word| OTHER_ANGLES.contains(&word.to_lowercase().as_str()))
}

/// `speed of the other sphere`, and where it is A that is asked, `speed of the second sphere`.
fn is_of_other_sphere(asked: Quantity, label: &str) -> bool {
    const SPHERES: [&str; 8] = ["sphere", "spheres", "ball", "balls", "particle", "particles", "disc", "one"];
    let words: Vec<String> = words(label).map(str::to_lowercase).collect();
    let is_other = |word: &str| match word {
        "other" => sphere(asked).is_some(),
        "second" => sphere(asked) == Some(Sphere::A),
        "first" => sphere(asked) == Some(Sphere::B),
        _ => false,
    };
    words.windows(2).any(|pair| is_other(&pair[0]) && SPHERES.contains(&&*pair[1]))
}

/// What was found of a value, if the words around it say nothing else of it.
pub(super) fn as_remarked(model: &Model, statement: &Statement, finding: Finding) -> Finding {
    if finding.is_credited() && besides::is_told_otherwise(model, statement) {
        return Finding::unreadable(Note::SeveralAnswers);
    }
    let Some(asked) = model.quantity else { return finding };
    if finding.is_credited() && sides::is_said_to_go_otherwise(model, statement) {
        return Finding::unreadable(Note::DirectionUnchecked);
    }
    // `at rest along the line of centres`: that component of it.
    let is_of_line = |said: &Said| said.form == Form::AtRest && said.reference.is_some();
    if finding.is_credited() && matches!(asked, Quantity::Speed(..)) && statement.said.iter().any(is_of_line) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let remarks: Vec<&String> = statement.remarks().collect();
    if remarks.is_empty() || !(finding.is_credited() || finding.note == Some(Note::Sign)) {
        return finding;
    }
    if remarks.iter().any(|remark| remark_names_another(model, asked, &remarks, remark)) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let label = statement.label.as_ref().map_or("", |label| &label.typed);
    let has = |wanted: &[&str]| remarks.iter().flat_map(|remark| words(remark)).any(|word| wanted.contains(&word));
    let is_loss = is_of_change(asked);
    // `13 lost 7 left`: of which of the two is it said?
    let is_bare = statement.label.is_some() && changes_in_words(asked).contains(&label.trim().to_lowercase().as_str());
    if is_loss && is_bare && has(states(asked)) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let calls_it_loss = has(changes_in_words(asked))
        || words(&label.to_lowercase()).any(|word| changes_in_words(asked).contains(&word));
    if is_loss && !calls_it_loss {
        if remarks.iter().any(|remark| is_opposite(asked, remark)) && finding.note != Some(Note::ChangeNotLoss) {
            return finding.at_most_partial(Note::Sign);
        }
        if has(states(asked)) {
            return Finding::unreadable(Note::NamedOtherwise);
        }
    }
    if moments::are_of_another(asked, &remarks) {
        return Finding::unreadable(Note::NamedOtherwise);
    }
    let is_to_no_line = |remark: &&String| matches!(remark.trim(), "to a" | "to b" | "to c" | "to it");
    let is_turned = match asked {
        // Back along the line, or to a side of the page that nobody has drawn.
        Quantity::Velocity(_, _, Axis::N) => {
            has(&["perpendicular", "perp", "left", "leftwards", "back", "backwards"])
                || remarks.iter().any(|remark| sides::says_that_it_goes_back(remark))
        }
        // `46.1° tangent`, `46.1° to B`: from which line?
        Quantity::AngleToLine(..) => {
            let is_alone = statement.said.iter().all(|said| said.reference.is_none());
            is_alone && (has(&OTHER_ANGLES) || has(&["tangent"]) || remarks.iter().any(is_to_no_line))
        }
        Quantity::Deflection(_) | Quantity::SignedDeflection(_) => remarks.iter().any(is_to_no_line),
        _ => false,
    };
    if is_turned { Finding::unreadable(Note::DirectionUnchecked) } else { finding }
}

/// Is it called a bearing, or measured from where north is?
pub(super) fn is_a_bearing(statement: &Statement) -> bool {
    let label = statement.label.iter().map(|label| label.typed.as_str());
    let remarks = statement.remarks().map(String::as_str);
    const BEARINGS: [&str; 5] = ["bearing", "north", "south", "east", "west"];
    label.chain(remarks).flat_map(words).any(|word| BEARINGS.contains(&word.to_lowercase().as_str()))
}

/// Do the words on the left name what is asked?
pub(in crate::mark) fn words_fit(model: &Model, typed: &str) -> bool {
    if is_multiplied(typed) {
        return false;
    }
    let Some(asked) = model.quantity else { return true };
    let small = typed.to_lowercase();
    let has = |wanted: &[&str]| words(&small).any(|word| wanted.contains(&word));
    let is_loss = is_of_change(asked);
    let is_share = asked != Quantity::FractionLost && has(&["fraction", "percentage", "proportion"]);
    // A loss is no quotient, and a fraction is none of what is left.
    let of_rest = |(_, below): (&str, &str)| words(below).any(|word| AT_THE_END.contains(&word));
    let is_quotient = match asked {
        Quantity::FractionLost => small.split_once('/').is_some_and(of_rest),
        _ => small.contains('/'),
    };
    if is_loss && (has(&["pe", "gpe", "potential"]) || is_share || is_quotient || small.contains('+')) {
        return false;
    }
    // `each loses`, and `total loss` for one sphere
    if is_loss
        && (has(&["each"])
            || matches!(asked, Quantity::SphereEnergyLost(_) | Quantity::SphereEnergyGained(_)) && has(&["total"]))
    {
        return false;
    }
    // `v lost`
    let is_of_another = |word: &str| matches!(of_letter(word), Some(Sort::Speed | Sort::Mass));
    if is_loss && words(typed).any(is_of_another) {
        return false;
    }
    // `KE2`, but `KE1 − KE2`
    let is_difference = small.contains(['-', '−', '–']) || has(&["minus"]);
    if is_loss && !is_difference && words(&small).any(moments::is_energy_of_one) {
        return false;
    }
    // `KE1 − loss`
    if is_loss
        && is_difference
        && small.split(['-', '−', '–']).skip(1).flat_map(words).any(|word| changes_in_words(asked).contains(&word))
    {
        return false;
    }
    // `total KE`, `KE falls to`
    if is_loss && ((has(&["total"]) && !has(changes_in_words(asked))) || is_changed_to(&small)) {
        return false;
    }
    if is_loss {
        return !has(states(asked))
            || has(changes_in_words(asked))
            || is_opposite(asked, typed)
            || is_change(typed)
            || is_difference;
    }
    if is_another_of_its_sort(model, asked, &small) {
        return false;
    }
    moments::fit(asked, &small)
}
