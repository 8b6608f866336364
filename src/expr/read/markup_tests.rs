//! Examples of marked-up words.

use super::*;
use crate::expr::print::{text_latex, text_unicode};
use crate::expr::{Expr, Piece};

fn shown(text: &str) -> Vec<String> {
    read_markup(text).unwrap_or_else(|fault| panic!("{text}: {fault:?}")).iter().map(text_unicode).collect()
}

#[test]
fn carom_knows_how_a_question_is_written() {
    let rows = [
        ("Sphere *A* of mass {2 kg} meets *B*.", "Sphere A of mass 2 kg meets B."),
        ("velocity {[4, -1] m/s}", "velocity (4i − j) m s⁻¹"),
        ("velocity {(4i - j) m/s}", "velocity (4i − j) m s⁻¹"),
        ("impulse {6 N s}, {12 J}, {0.5 m}", "impulse 6 N s, 12 J, 0.5 m"),
        ("at {30 deg} to it", "at 30° to it"),
        ("where {tan(alpha) = 3/4}", "where tan α = 3/4"),
        ("mass {k * m}, {m}, {2m}", "mass km, m, 2m"),
        ("speed {u = 2.50 m/s}", "speed u = 2.50 m s⁻¹"),
        ("speed {6sin10 m/s}", "speed 6 sin 10° m s⁻¹"),
        ("a {{brace}} and 3 * 4 * 5, snake_case, ____", "a {brace} and 3 * 4 * 5, snake_case, ____"),
        ("  two \n  lines ", "two lines"),
        ("_In this question {e} is *e*._ Find", "In this question e is e. Find"),
    ];
    for (text, expected) in rows {
        assert_eq!(shown(text), [expected], "{text}");
    }
    assert_eq!(shown("one\n\ntwo\n \t\n\nthree\n"), ["one", "two", "three"]);
    assert!(shown(" \n\n").is_empty());
}

#[test]
fn carom_knows_italics_and_displays() {
    let latex = |text: &str| text_latex(&read_markup(text).unwrap()[0]);
    assert_eq!(latex("(_italic words_, {v_A}_1)"), r"(\textit{italic words}, $v_A$\_1)");
    assert_eq!(
        latex("Show that {display: tan(beta) = 2*tan(alpha)/(1-e)}"),
        r"Show that \[\tan\beta=\frac{2\tan\alpha}{1-e}\]"
    );
}

#[test]
fn carom_knows_where_marked_up_words_go_wrong() {
    let rows = [
        ("mass {2 kg", "`{` is never closed", "{"),
        ("e is {\\frac{1}{2}}", "unknown character `\\`", "\\"),
        ("mass 2} kg", "`}` closes nothing", "}"),
        ("one\n\nsphere _with {u + $}_", "unknown character `$`", "$"),
        ("é {}", "an empty expression", ""),
        ("{display: = 2}", "a relation without its left side", "="),
        ("{2 2 kg}", "a number without a sign before it", "2"),
    ];
    for (text, message, at) in rows {
        let fault = read_markup(text).unwrap_err();
        assert_eq!(fault.message, message, "{text}");
        assert_eq!(&text[fault.span.start..fault.span.end], at, "{text}");
    }
}

#[test]
fn carom_knows_each_name_of_a_text_by_its_place() {
    let text = "é *A*: {mA kg}\n\n_see {2u + v_B}_ {display: x = y}";
    let read = read_markup(text).unwrap();
    let mut found = Vec::new();
    for name in read.iter().flat_map(|paragraph| paragraph.names()) {
        assert_eq!(&text[name.span.start..name.span.end], name.text);
        found.push(name.text.clone());
    }
    assert_eq!(found, ["A", "mA", "u", "v_B", "x", "y"]);
}

#[test]
fn carom_knows_how_to_fill_in_numbers() {
    let read = read_markup("_mass {mA kg}_, velocity {[p, q] m/s}").unwrap();
    let filled = read[0].map_formulas(&mut |formula| {
        Ok::<_, ()>(formula.substitute(&|name| match name {
            "mA" => Some(Expr::integer(3)),
            "p" => Some(Expr::integer(-1)),
            "q" => Some(Expr::integer(2)),
            _ => None,
        }))
    });
    assert_eq!(text_unicode(&filled.unwrap()), "mass 3 kg, velocity (−i + 2j) m s⁻¹");
    assert_eq!(read[0].map_formulas(&mut |_| Err("no")), Err("no"));
    assert!(matches!(&read[0].0[0], Piece::Italic(_)));
}

#[test]
fn carom_knows_that_no_words_can_stop_it() {
    let pieces =
        ["{", "}", "*", "_", "A", " ", "\n", "\n\n", "é", "kg", "2", "display:", "{{", "m/s", "deg", "\u{2028}"];
    let mut state = 7_u64;
    for _ in 0..30_000 {
        let mut text = String::new();
        for _ in 0..12 {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            text.push_str(pieces[(state >> 40) as usize % pieces.len()]);
        }
        match read_markup(&text) {
            Ok(read) => assert!(read.iter().all(|paragraph| !paragraph.is_empty()), "{text:?}"),
            Err(fault) => assert!(text.get(fault.span.start..fault.span.end).is_some(), "{text:?}: {fault:?}"),
        }
    }
}
