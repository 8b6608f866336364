//! Models, printed results and notes.

use super::*;
use crate::mark::reading::Vocabulary;

#[test]
fn a_model_fits_its_kind_or_is_refused() {
    for (text, kind) in [
        ("4*i + j", Kind::Vector),
        ("[4, 1]", Kind::Vector),
        ("2.5", Kind::Number),
        ("6*sin(10*deg)", Kind::Number),
        ("u*sin(alpha)", Kind::Expression),
        ("atan(7)/deg", Kind::Angle),
        ("30 deg", Kind::Angle),
        ("2*pi/3", Kind::Number),
        ("v = 2*u", Kind::Equation),
    ] {
        assert_eq!(model(text, None, "").kind, kind, "{text}");
    }
    let of = |kind| ModelOptions { kind: Some(kind), ..ModelOptions::default() };
    for (text, kind) in [
        ("4", Kind::Vector),
        ("v = 2*u", Kind::Number),
        ("2*u", Kind::Equation),
        ("4*i", Kind::Angle),
        ("sqrt(-1)", Kind::Number),
        ("1/0", Kind::Number),
        ("", Kind::Number),
        ("sin(10)", Kind::Number),
    ] {
        assert!(Model::read(text, &of(kind)).is_err(), "{text} as {}", kind.name());
    }
}

#[test]
fn every_model_accepts_what_carom_prints_of_it() {
    for text in ["4*sqrt(39)/9", "10/43", "7*sqrt(2)/9 + 77/54", "sqrt(61)*v/6", "u*cos(alpha)*(1-e)/2", "48/25"] {
        let model = model(text, None, "");
        assert_eq!(tests::on(&model, text), "correct");
        assert_eq!(tests::on(&model, &print::plain(&model.value)), "correct");
    }
}

#[test]
fn a_printed_result_is_never_earned_by_its_last_line() {
    let shown = model("tan(beta) = 2*tan(alpha)/(1-e)", Some(Kind::Shown), "");
    let shown = Model {
        vocabulary: Vocabulary {
            letters: [
                shown.vocabulary.letters.clone(),
                vec![crate::number::Letter::new("u", crate::number::Range::Positive).unwrap()],
            ]
            .concat(),
            ..shown.vocabulary.clone()
        },
        ..shown
    };
    let steps =
        |label: &str, texts: &[&str]| earns(&shown, Some(label), texts.iter().map(|text| value(text)).collect());
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)/(1-e)"]), "wrong restated");
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)/(1-e)", "2*tan(alpha)/(1-e)"]), "wrong restated");
    let derived = "u*sin(alpha)/(1/2*u*cos(alpha)*(1-e))";
    assert_eq!(steps("tan(beta)", &[derived, "2*tan(alpha)/(1-e)"]), "partial working-not-judged");
    assert_eq!(steps("(1-e)*tan(beta)", &["2*tan(alpha)"]), "partial not-as-printed");
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)", "2*tan(alpha)/(1-e)"]), "wrong working-not-judged");
    assert_eq!(steps("tan(beta)", &["2*tan(alpha)/(1+e)"]), "wrong working-not-judged");
}

#[test]
fn notes_have_tags_in_kebab_case_and_sentences() {
    let mut tags: Vec<&str> = Note::ALL.iter().map(|note| note.tag()).collect();
    for note in Note::ALL {
        let tag = note.tag();
        assert!(tag.chars().all(|letter| letter.is_ascii_lowercase() || letter == '-'), "{tag}");
        assert!(note.sentence().ends_with('.'), "{tag}");
    }
    tags.sort_unstable();
    tags.dedup();
    assert_eq!(tags.len(), Note::ALL.len());
}
