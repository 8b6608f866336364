//! Worked solutions as they are read: an equation has a number because a later line refers to it.

use carom::bank::{Bank, EarnedFor, Question};
use carom::diagnostic::render_all;
use carom::expr::{Expr, Relation, print};
use carom::generate::{Deal, Variant, reference};
use carom::paper::{PrintedQuestion, compose};

/// How many variants of each style are read.
const READ: usize = 12;

/// The numbers in brackets of a sentence: `Subtracting (2) from (1)`.
fn mentioned(words: &str) -> Vec<u32> {
    words.split('(').skip(1).filter_map(|rest| rest.split(')').next()?.parse().ok()).collect()
}

/// Equations with a number that nobody refers to, and references to no equation.
fn faults(printed: &PrintedQuestion) -> Vec<String> {
    let mut faults = Vec::new();
    let mut waiting: Vec<u32> = Vec::new();
    let mut known: Vec<u32> = Vec::new();
    for line in printed.parts.iter().flat_map(|part| &part.working) {
        for number in mentioned(&print::text_unicode(&line.words)) {
            waiting.retain(|label| *label != number);
            if !known.contains(&number) {
                faults.push(format!("({number}) is referred to before it stands there"));
            }
        }
        if let Some(label) = line.label {
            if waiting.contains(&label) {
                faults.push(format!("({label}) stands there again before anybody referred to it"));
            }
            waiting.push(label);
            known.push(label);
        }
    }
    faults.extend(waiting.iter().map(|label| format!("nobody refers to ({label})")));
    faults
}

/// Equations that say nothing: both sides read the same.
fn idle(printed: &PrintedQuestion) -> Vec<String> {
    let lines = printed.parts.iter().flat_map(|part| &part.working);
    let in_words = lines.clone().flat_map(|line| line.words.formulas());
    let schemes = printed.parts.iter().flat_map(|part| &part.scheme).flat_map(|row| &row.equations);
    let equations = lines.flat_map(|line| &line.equations).chain(in_words).chain(schemes);
    let both = |equation: &&Expr| match equation {
        Expr::Relation(left, _, right) => print::plain(left) == print::plain(right),
        _ => false,
    };
    equations.filter(both).map(|equation| format!("`{}` says nothing", print::unicode(equation))).collect()
}

/// Chains that go on as if exact after they were rounded, and rows of the mark scheme with a value that is not there.
fn gaps(question: &Question, printed: &PrintedQuestion) -> Vec<String> {
    let mut gaps = Vec::new();
    for line in printed.parts.iter().flat_map(|part| &part.working) {
        for pair in line.equations.windows(2) {
            if let [Expr::Relation(left, Relation::Approximately, _), Expr::Relation(next, Relation::Equal, right)] =
                pair
                && left == next
            {
                gaps.push(format!("`= {}` follows what is rounded", print::unicode(right)));
            }
        }
    }
    for (part, printed) in question.parts.iter().zip(&printed.parts) {
        for (mark, row) in part.marks.iter().zip(&printed.scheme) {
            let has_value = !matches!(mark.earned_for, EarnedFor::Law(..));
            let note = print::text_unicode(&row.note);
            if has_value && row.equations.is_empty() && !note.contains("awrt") {
                gaps.push(format!("`{}` for {} has no value", row.id, mark.earned_for));
            }
        }
    }
    gaps
}

#[test]
fn every_numbered_equation_is_referred_to_and_every_reference_has_its_equation() {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let (mut complaints, mut numbered) = (Vec::new(), 0);
    let mut read = |question: &Question, variant: &Variant| {
        let printed = compose(question, variant, 1);
        numbered += printed.parts.iter().flat_map(|part| &part.working).filter(|line| line.label.is_some()).count();
        let name = format!("{} {} {:?}", question.id, variant.style.name(), variant.index);
        complaints.extend(
            faults(&printed)
                .into_iter()
                .chain(idle(&printed))
                .chain(gaps(question, &printed))
                .map(|fault| format!("{name}: {fault}")),
        );
    };
    for question in &bank.questions {
        read(question, &reference(question).unwrap_or_else(|_| panic!("{}", question.id)));
        for style in &question.styles {
            Deal::new(question, style, 3).take(READ).for_each(|variant| read(question, &variant));
        }
    }
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
    assert!(numbered > 500, "only {numbered} equations have a number");
}

#[test]
fn a_number_that_nobody_refers_to_is_noticed() {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let question = bank.find("rest/speeds-and-directions").unwrap();
    let variant = reference(question).unwrap_or_else(|_| panic!("the reference"));
    let mut printed = compose(question, &variant, 1);
    assert!(faults(&printed).is_empty());
    let working = &mut printed.parts[0].working;
    let last = working.iter_mut().rev().find(|line| !line.equations.is_empty()).unwrap();
    last.label = Some(9);
    assert_eq!(faults(&printed), ["nobody refers to (9)"]);
}

/// Questions that are put in unit vectors, or whole folders of them.
const IN_VECTORS: [&str; 7] = [
    "i-j/",
    "backwards/",
    "successive/corner",
    "successive/walls-at-an-angle",
    "vector-impulse/",
    "walls/velocity-in-i-and-j",
    "walls/wall-along-a-vector",
];

#[test]
fn the_working_speaks_of_unit_vectors_only_where_its_question_does() {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let says_bold = |texts: Vec<&carom::expr::Text>| {
        let names = texts.into_iter().flat_map(|text| text.formulas()).flat_map(Expr::names);
        names.into_iter().any(|name| matches!(name.text.as_str(), "i" | "j"))
    };
    for question in &bank.questions {
        let variant = reference(question).unwrap_or_else(|_| panic!("{}", question.id));
        let printed = compose(question, &variant, 1);
        let (vectors, id) = (printed.stem.iter().any(|text| says_bold(vec![text])), &question.id);
        assert_eq!(vectors, IN_VECTORS.iter().any(|folder| id.starts_with(folder)), "{id}");
        let lines = printed.parts.iter().flat_map(|part| &part.working).map(|line| &line.words).collect();
        assert!(vectors || !says_bold(lines), "{id} works with i or j");
    }
}

/// A question of the shipped bank with the numbers of its reference.
fn with_reference_numbers(id: &str) -> PrintedQuestion {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let question = bank.find(id).unwrap();
    compose(question, &reference(question).unwrap_or_else(|_| panic!("{id}")), 1)
}

#[test]
fn after_a_wall_the_mark_scheme_and_the_working_have_the_component_away_from_it() {
    let printed = with_reference_numbers("successive/sphere-wall-sphere");
    let part = &printed.parts[1];
    let worked = part.working.iter().flat_map(|line| &line.equations).map(print::plain);
    assert!(worked.into_iter().any(|equation| equation.ends_with("= 6")));
    let rows: Vec<String> = part.scheme.iter().flat_map(|row| &row.equations).map(print::plain).collect();
    assert_eq!(rows, ["x = (2/3)*9", "x = 6", "I = 2*(-6 - 9)", "30"]);
    let note =
        print::text_unicode(&with_reference_numbers("walls/rebound-speed-and-direction").parts[0].scheme[2].note);
    assert!(!note.contains('−'), "{note}");
}

/// The lines of a part, one under the other, words and equations.
fn told(printed: &PrintedQuestion, part: usize) -> String {
    let lines = printed.parts[part].working.iter();
    let line = |line: &carom::paper::WorkingLine| {
        let words = std::iter::once(print::text_unicode(&line.words));
        words.chain(line.equations.iter().map(print::unicode)).collect::<Vec<_>>()
    };
    lines.flat_map(line).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_letter_is_found_in_steps_that_can_be_followed_and_put_in() {
    let printed = with_reference_numbers("vector-impulse/mass-from-the-speed-after");
    let found = told(&printed, 0);
    for step in ["Squaring both sides and collecting terms:", "m² ", " = 0\n(", " or m = −", "and m is positive:\nm = "]
    {
        assert!(found.contains(step), "`{step}` is not in\n{found}");
    }
    let put_in = told(&printed, 1);
    assert!(put_in.starts_with("With m = "), "{put_in}");
    assert!(!put_in.contains("impulse"), "{put_in}");
}

#[test]
fn the_greatest_deflection_is_found_by_a_derivative_and_not_by_solving_the_impact_twice() {
    let told = told(&with_reference_numbers("deflection/elastic"), 0);
    assert!(told.contains("d tan δ/(d tan α) = "), "{told}");
    assert_eq!(told.matches("Newton's law").count(), 1, "{told}");
    assert!(told.contains("With α = 30°,"), "{told}");
}

#[test]
fn what_is_to_be_shown_ends_the_working() {
    let told = told(&with_reference_numbers("rest-letters/turned-through-a-right-angle"), 0);
    assert!(told.ends_with("as required.") && !told.contains('≈'), "{told}");
}

#[test]
fn the_angle_with_each_wall_has_the_letter_that_the_question_gives_it() {
    let printed = with_reference_numbers("successive/tangents-at-two-walls");
    let letters = ["beta", "gamma"];
    for (part, letter) in printed.parts.iter().zip(letters) {
        let worked = part.working.iter().flat_map(|line| &line.equations);
        let names: Vec<&str> = worked.flat_map(Expr::names).map(|name| name.text.as_str()).collect();
        let angles: Vec<&str> = letters.into_iter().filter(|letter| names.contains(letter)).collect();
        assert_eq!(angles, [letter]);
    }
}

#[test]
fn the_deflection_has_the_letter_that_the_question_gives_it() {
    let told = told(&with_reference_numbers("rest-letters/direction-and-deflection"), 1);
    assert!(told.contains("The deflection δ of A") && told.contains("tan δ = "), "{told}");
}

#[test]
fn the_angle_turned_through_is_found_by_the_function_that_the_line_before_has() {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let mut by_cosine = 0;
    for question in &bank.questions {
        let id = &question.id;
        let printed = compose(question, &reference(question).unwrap_or_else(|_| panic!("{id}")), 1);
        for line in printed.parts.iter().flat_map(|part| &part.working) {
            let found = line.equations.iter().map(print::unicode).collect::<Vec<_>>().join("\n");
            let Some((_, then)) = found.split_once("cos δ = ") else { continue };
            assert!(!then.contains("arctan"), "{id}:\n{found}");
            by_cosine += usize::from(then.contains("δ = arccos"));
        }
    }
    assert!(by_cosine > 0);
}

#[test]
fn a_mark_scheme_speaks_of_restitution_by_the_letter_of_the_impact() {
    let printed = with_reference_numbers("successive/no-more-collisions");
    let notes: Vec<String> =
        printed.parts.iter().flat_map(|part| &part.scheme).map(|row| print::text_unicode(&row.note)).collect();
    assert!(notes.iter().any(|note| note.contains("f on the correct side")), "{notes:?}");
}

#[test]
fn a_letter_that_every_mass_has_is_divided_out_of_momentum() {
    let told = told(&with_reference_numbers("ranges/mass-ratio-when-a-goes-on"), 0);
    assert!(told.contains("km × 2u − mu = kmv + mw\nkv + w = u(2k − 1)"), "{told}");
    assert!(told.contains("Subtracting equation (2) from equation (1):\n(1 + k)v = "), "{told}");
}
