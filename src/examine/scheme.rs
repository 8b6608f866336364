//! Does each mark stand for a step that the question takes, and does each answer earn one?

use super::finding::Finding;
use crate::answer::Kind;
use crate::bank::{Answer, Code, Contents, EarnedFor, Find, Mark, Part, Question};
use crate::diagnostic::near;
use crate::generate::reference;
use crate::paper::{compose, key_question};

/// The exercises that questions of the shipped bank mirror.
pub fn exercises() -> Vec<String> {
    Contents::shipped().headings.into_iter().filter_map(|heading| heading.mirrors).collect()
}

/// That a question mirrors an exercise of a series in which there is none of this name. Other books have other names.
pub fn unknown_exercise(question: &Question, known: &[String]) -> Option<Finding> {
    let mirrors = question.mirrors.as_ref().filter(|mirrors| !known.contains(mirrors))?;
    let series = &mirrors[..mirrors.find('-')? + 1];
    known.iter().find(|exercise| exercise.starts_with(series))?;
    let message = format!("there is no exercise `{mirrors}`");
    let help = match near(mirrors, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "take the line out if the question practises the skills of none".to_owned(),
    };
    let found = Finding::new(message, format!("\"{mirrors}\""), "`carom list` names those that there are");
    Some(found.with_help(help).as_warning())
}

/// Marks that belong to no answer, and answers to which no mark for a right result belongs.
pub fn unrewarded(question: &Question) -> Vec<Finding> {
    let Ok(variant) = reference(question) else { return Vec::new() };
    let keyed = key_question(question, &variant, &compose(question, &variant, 1));
    let has_values = question.parts.iter().any(|part| {
        let value = |answer: &Answer| part.marks.iter().any(|mark| is_value_of(&mark.earned_for, &answer.find));
        part.answers.iter().any(value)
    });
    let mut findings = Vec::new();
    for (place, part) in keyed.parts.iter().enumerate() {
        for (row, mark) in part.scheme.iter().enumerate().filter(|(_, mark)| mark.blanks.is_empty()) {
            let (mark, step) = (&mark.id, &mark.earned_for);
            let message = format!(
                "the mark {mark} is never won, not even by the model solution: it is for `{step}`, a step that no answer of its \
                 part takes"
            );
            let help = "name a step of the worked solution, which `carom preview` shows, or take the row out";
            findings.push(Finding::new(message, "", "nobody can earn it").with_help(help).at_row(place, "marks", row));
        }
        let asked = &question.parts[place];
        for (row, (blank, answer)) in part.blanks.iter().zip(&asked.answers).enumerate() {
            let rewards = |code: &str| code.starts_with(['A', 'B']);
            let own = part.scheme.iter().zip(&asked.marks).any(|(keyed, mark)| {
                let belongs = || {
                    let is_its = keyed.blanks.contains(&blank.name) && is_for(&mark.earned_for, &answer.find);
                    // The equation of a law is on the way to an inequality.
                    let is_on_the_way = answer.kind == Kind::Range && matches!(mark.earned_for, EarnedFor::Law(..));
                    is_its && !is_on_the_way && !(has_values && is_for_the_equation(mark, asked, answer))
                };
                rewards(&keyed.code) && (belongs() || is_beside(&mark.earned_for, &answer.find))
            });
            if !own {
                let message = format!("no accuracy mark is for the answer `{}`", blank.name);
                let help = "add a row with `code = \"A1\"` that is `for` what it finds";
                let found = Finding::new(message, "", "a wrong value costs nothing");
                findings.push(found.with_help(help).at_row(place, "answers", row).as_warning());
            }
        }
    }
    findings
}

/// Marks that are earned with others: twice for one value in a part, or again for what an earlier part has found.
pub fn paid_twice(question: &Question) -> Vec<Finding> {
    let is_value =
        |mark: &Mark| matches!(mark.earned_for, EarnedFor::Quantity(_) | EarnedFor::Both(_) | EarnedFor::Unknown(_));
    let mut findings = used_twice(question);
    for (place, part) in question.parts.iter().enumerate() {
        let mut told: Vec<&EarnedFor> = Vec::new();
        for (row, mark) in part.marks.iter().enumerate().filter(|(_, mark)| mark.code.is_accuracy() && is_value(mark)) {
            let is_same = |other: &&Mark| {
                (other.code, &other.earned_for, &other.text) == (mark.code, &mark.earned_for, &mark.text)
            };
            let step = &mark.earned_for;
            if let Some(other) = part.marks[..row].iter().find(is_same).filter(|_| !told.contains(&step)) {
                told.push(step);
                let message = format!("the marks {} and {} are both for the value of `{step}`", other.id, mark.id);
                let help = "take one of the two rows out, or name another step in it";
                let found = Finding::new(message, "", "who earns the one earns the other");
                findings.push(found.with_help(help).at_row(place, "marks", row).as_warning());
            }
            let asks = |part: &Part| part.answers.iter().any(|answer| is_value_of(step, &answer.find));
            let pays = |part: &&Part| asks(part) && part.marks.iter().any(|other| is_same(&other));
            if let Some(before) = question.parts[..place].iter().find(pays).filter(|_| !asks(part)) {
                let message =
                    format!("the mark {} is for `{step}`, for which part ({}) has paid", mark.id, before.label);
                let help = "name what this part finds, or take the row out";
                let found = Finding::new(message, "", "who earns it there earns it here");
                findings.push(found.with_help(help).at_row(place, "marks", row).as_warning());
            }
        }
    }
    findings
}

/// Marks for the use of one law in a part that takes it once, or for its equation.
fn used_twice(question: &Question) -> Vec<Finding> {
    let mut findings = Vec::new();
    // In a later impact a law is used again.
    for (place, part) in question.parts.iter().enumerate().filter(|_| question.scene.then.is_empty()) {
        for (row, mark) in part.marks.iter().enumerate() {
            let is_law = matches!(mark.earned_for, EarnedFor::Law(..) | EarnedFor::Condition);
            let is_same = |other: &&Mark| {
                (other.code, &other.earned_for, &other.text) == (mark.code, &mark.earned_for, &mark.text)
            };
            if let Some(other) = part.marks[..row].iter().find(is_same).filter(|_| is_law) {
                let step = &mark.earned_for;
                let message = format!("the marks {} and {} are both for `{step}`", other.id, mark.id);
                let help = "take one of the two rows out, or say in `text` what else earns it";
                let found = Finding::new(message, "", "who earns the one earns the other");
                findings.push(found.with_help(help).at_row(place, "marks", row).as_warning());
            }
        }
    }
    findings
}

/// Is a step the value that an answer finds?
fn is_value_of(step: &EarnedFor, find: &Find) -> bool {
    match step {
        EarnedFor::Unknown(name) => *find == Find::Unknown(name.clone()),
        values => values.quantities().iter().any(|quantity| find.quantities().contains(quantity)),
    }
}

/// Is a mark for the value of an answer, and not for a step on the way to it?
fn is_for(earned_for: &EarnedFor, find: &Find) -> bool {
    let quantities = find.quantities();
    match earned_for {
        EarnedFor::Quantity(_) | EarnedFor::Both(_) | EarnedFor::Unknown(_) => is_value_of(earned_for, find),
        EarnedFor::Condition => matches!(find, Find::Unknown(_)),
        EarnedFor::Law(law, _) => quantities.iter().any(|quantity| law.gives(quantity.of_its_impact())),
    }
}

/// Beside a mark for the method of a law the accuracy mark of the law is for its equation, and a number that comes out of it
/// wants a mark of its own.
fn is_for_the_equation(mark: &Mark, part: &Part, answer: &Answer) -> bool {
    let is_law = matches!(mark.earned_for, EarnedFor::Law(..)) && mark.code == Code::A1;
    let has_method = || part.marks.iter().any(|other| other.code.is_method() && other.earned_for == mark.earned_for);
    is_law && answer.kind != Kind::Shown && matches!(answer.find, Find::Quantity(_)) && has_method()
}

/// Is it the mark for a speed, which is for the direction beside it as well?
fn is_beside(earned_for: &EarnedFor, find: &Find) -> bool {
    find.quantities().iter().any(|direction| earned_for.is_speed_beside(*direction))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::{read_question, shipped};
    use crate::diagnostic::Source;
    use crate::examine::words;
    use crate::generate::Deal;
    use crate::paper;

    #[test]
    fn the_numbers_words_and_marks_of_every_shipped_question_are_in_order() {
        let exercises = exercises();
        assert!(exercises.len() >= 17);
        let mut amiss: Vec<String> = Vec::new();
        for (id, text) in shipped() {
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let mut found = unrewarded(&question);
            found.extend(unknown_exercise(&question, &exercises));
            found.extend(words::of_question(&question));
            found.extend(paid_twice(&question));
            amiss.extend(found.into_iter().map(|finding| format!("{id}: {}", finding.message)));
            for style in &question.styles {
                let mut remarks = Vec::new();
                let variant = Deal::new(&question, style, 1).next().unwrap();
                let words = paper::words(&question, style, &variant);
                words::of_variant(&question, &variant, &words, &mut words::Heard::default(), &mut remarks);
                amiss.extend(
                    words::contradicted(&question, style, &variant).iter().map(|found| format!("{id}: {found:?}")),
                );
                amiss.extend(remarks.iter().map(|remark| format!("{id}: {remark:?}")));
            }
        }
        assert!(amiss.is_empty(), "{amiss:#?}");
    }

    #[test]
    fn a_mark_on_the_way_to_an_answer_is_no_mark_for_it() {
        let (id, text) = shipped().find(|(id, _)| *id == "rest/speeds-and-directions").unwrap();
        // The mark for a speed is for its direction as well, and that for a component on the way is for neither.
        for (step, lacking) in [
            ("A.after.n", &[][..]),
            ("A.after.angle_to_loc_deg", &[]),
            ("A.after.speed", &["speed of A"]),
            ("B.after.speed", &["speed of B", "direction of B"]),
        ] {
            let is_its_row = |line: &&str| line.contains("\"A1\"") && line.contains(&format!("for = \"{step}\""));
            let row = text.lines().find(is_its_row).unwrap();
            let without = text.replacen(&format!("{row}\n"), "", 1);
            let question = read_question(id, &Source::new(id, without)).unwrap();
            let found: Vec<String> = unrewarded(&question).into_iter().map(|finding| finding.message).collect();
            let expected = lacking.iter().map(|name| format!("no accuracy mark is for the answer `{name}`"));
            assert_eq!(found, expected.collect::<Vec<_>>(), "{step}");
        }
    }

    #[test]
    fn a_mark_for_the_equation_of_a_law_is_none_for_a_range() {
        let (id, text) = shipped().find(|(id, _)| *id == "ranges/direction-reversed").unwrap();
        for (step, is_told) in [("e", false), ("momentum", true)] {
            let text = text.replacen("{ code = \"A1\", for = \"e\"", &format!("{{ code = \"A1\", for = \"{step}\""), 1);
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let found: Vec<String> = unrewarded(&question).into_iter().map(|finding| finding.message).collect();
            assert_eq!(found == ["no accuracy mark is for the answer `values of e`"], is_told, "{step}: {found:?}");
            assert!(is_told || found.is_empty());
        }
    }

    #[test]
    fn a_mark_for_a_step_that_leads_to_no_letter_is_never_won() {
        let (id, text) = shipped().find(|(id, _)| *id == "walls/turned-through-a-right-angle").unwrap();
        for (step, is_taken) in [
            ("perpendicular", true),
            ("resolve", true),
            ("A.after.n", true),
            ("impulse", false),
            ("energy", false),
            ("impulse.magnitude", false),
        ] {
            let text = text.replacen("\"B1\", for = \"perpendicular\"", &format!("\"B1\", for = \"{step}\""), 1);
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let found: Vec<String> = unrewarded(&question).into_iter().map(|finding| finding.message).collect();
            assert_eq!(found.is_empty(), is_taken, "{step}: {found:?}");
        }
    }

    #[test]
    fn steps_to_a_letter_lead_to_what_follows_from_it() {
        let (id, text) = shipped().find(|(id, _)| *id == "deflection/greatest-deflection").unwrap();
        let part = |find: &str, step: &str| {
            format!(
                "[[part]]\nask = \"Find it.\"\nanswers = [{{ name = \"answer\", find = \"{find}\" }}]\nmarks = [\n  \
                 {{ code = \"M1\", for = \"{step}\" }},\n  {{ code = \"A1\", for = \"{find}\" }},\n]\n\n[reference]"
            )
        };
        let (before, rest) = text.split_once("[[part]]").unwrap();
        let (_, numbers) = rest.split_once("[reference]").unwrap();
        for (find, step, is_taken) in [
            ("A.before.tan_to_loc", "momentum", true),
            ("A.before.tan_to_loc", "restitution", true),
            ("A.before.tan_to_loc", "condition", true),
            ("A.before.tan_to_loc", "impulse", false),
            ("A.deflection_deg", "energy", false),
        ] {
            let text = format!("{before}{}{numbers}", part(find, step));
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let found: Vec<String> = unrewarded(&question).into_iter().map(|finding| finding.message).collect();
            assert_eq!(found.is_empty(), is_taken, "{find}, {step}: {found:?}");
        }
    }

    #[test]
    fn two_rows_for_the_equation_of_one_law_are_one() {
        let (id, text) = shipped().find(|(id, _)| *id == "rest/speeds-and-directions").unwrap();
        let row = "  { code = \"A1\", for = \"momentum\" },\n";
        for (more, said) in [("", ""), (row, "the marks A1a and A1b are both for `momentum`")] {
            let text = text.replacen(row, &format!("{row}{more}"), 1);
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let found: String = paid_twice(&question).into_iter().map(|finding| finding.message).collect();
            assert_eq!(found, said);
        }
    }

    #[test]
    fn an_exercise_of_another_series_is_left_alone() {
        let (id, text) = shipped().find(|(_, text)| text.contains("mirrors = \"5C-2\"")).unwrap();
        for (name, said) in
            [("5C-22", "did you mean `5C-2`?"), ("5C-xyz", "take the line out"), ("M4-7", ""), ("12", "")]
        {
            let text = text.replacen("\"5C-2\"", &format!("\"{name}\""), 1);
            let question = read_question(id, &Source::new(id, text)).unwrap();
            let found = unknown_exercise(&question, &exercises());
            let help = found.and_then(|found| found.help).unwrap_or_default();
            assert!(help.contains(said) && help.is_empty() == said.is_empty(), "{name}: {help}");
        }
    }
}
