//! The page that a student gets back, in every format: a script with a mistake of each kind, explained and followed through.

use std::fs;

use carom::expr::{Angles, Text, read};
use carom::mark::report::{Feedback, MarkReport};
use carom::mark::submissions::{read_overrides, read_rows, sort};
use carom::mark::{AnswerKey, Award, Cause, Evidence, MarkedLine, MarkedPart, Place, Profile};
use carom::paper::{Key, WorkingLine, compose, key_question};
use carom::{bank, diagnostic::Source, generate};

/// The key of two shipped questions, one of them in parts.
pub fn key() -> AnswerKey {
    let wanted = ["rest/speeds-and-directions", "both-moving/energy-lost-and-impulse"];
    let found = bank::shipped().filter(|(id, _)| wanted.iter().any(|name| id.starts_with(name)));
    let found: Vec<_> = found.collect();
    let questions = found.iter().enumerate().map(|(place, (id, text))| {
        let question = bank::read_question(id, &Source::new(*id, *text)).unwrap();
        let variant = generate::reference(&question).unwrap();
        key_question(&question, &variant, &compose(&question, &variant, place + 1))
    });
    let key = Key::new("shipped".to_owned(), Some(7), questions.collect());
    AnswerKey::read(&serde_json::to_string(&key).unwrap()).unwrap()
}

/// What is handed in: names and answers as nasty as they come.
const ROWS: &str = "student,question,part,blank,answer,working
Ada Lovelace,1,,speed of A,2.8 m/s,\"v = 4sin30 = 2
4*4cos30 = 4v + 2w\"
Ada Lovelace,1,,direction of A,43.9°,
Ada Lovelace,1,,speed of B,5.33,
Ada Lovelace,1,,direction of B,over there,
}\\input{/etc/passwd}<script>alert(1)</script>$&#_^~%,1,,speed of A,\"\\end{document}<b>√39</b> 中文\",
}\\input{/etc/passwd}<script>alert(1)</script>$&#_^~%,1,,speed of B,LONG,
";

fn words(text: &str) -> Text {
    Text::words(text)
}

/// Lines, causes and a mark that was followed through, as the marker sets them.
fn explained(part: &mut MarkedPart) {
    part.lines = vec![
        MarkedLine {
            typed: "v = 4sin30 = 2".into(),
            reading: Some("v = 4 sin 30°".into()),
            role: "component of A perpendicular to the line of centres".into(),
        },
        MarkedLine { typed: "then it bounces".into(), reading: None, role: String::new() },
    ];
    part.answers[1].causes = vec![
        Cause {
            tag: "complement".into(),
            sentence: "That is the angle to the common tangent: divide the other way round.".into(),
            probable: vec!["M1d".into()],
        },
        Cause { tag: "sincos-swap".into(), sentence: "Sine and cosine are exchanged.".into(), probable: Vec::new() },
    ];
    let award: &mut Award = &mut part.awards[7];
    award.given = true;
    award.note = Some("follow-through");
    award.feedback = "right from their own component of A".into();
    award.evidence = Some(Evidence { place: Place::Line(1), reading: "v = 4 sin 30°".into() });
    let equation = |text: &str| read(text, Angles::Degrees).unwrap();
    part.followed = vec![
        WorkingLine {
            words: words("Conservation of momentum with your component:"),
            equations: vec![equation("4*4*cos(30) = 4*2 + 2*w")],
            label: Some(1),
        },
        WorkingLine { words: words("The speed of B:"), equations: vec![equation("w = 8*sqrt(3) - 4")], label: None },
    ];
}

/// Calls with each page of a small class.
pub fn pages(look: impl FnOnce(&[Feedback])) {
    let key = key();
    let rows = ROWS.replace("LONG", &"9".repeat(5000));
    let sorted = sort(&key, read_rows(&Source::new("submissions.csv", rows.as_str())).unwrap());
    assert_eq!(sorted.set_aside, []);
    let overrides =
        Source::new("overrides.csv", "student,question,mark,given,comment\nAda Lovelace,1,A1e,1,seen in the margin\n");
    let overrides = read_overrides(&overrides, &key).unwrap();
    let mut report = MarkReport::new(&sorted.scripts, &Profile::default(), overrides);
    explained(&mut report.scripts[0].parts[0].marked);
    look(&Feedback::of(&report));
}

#[test]
fn carom_knows_the_page_that_a_student_gets_back() {
    let formats = carom::render::Formats::shipped().unwrap();
    let accept = std::env::var_os("CAROM_ACCEPT").is_some();
    pages(|pages| {
        for (format, _) in formats.list() {
            let page = formats.feedback(format, &pages[0]).unwrap().unwrap();
            assert!(page.name.starts_with("ada-lovelace."), "{}", page.name);
            let path = super::folder().join(page.name.replace("ada-lovelace", "feedback"));
            if accept {
                fs::write(&path, &page.contents).unwrap();
            }
            let known = fs::read_to_string(&path).unwrap_or_default();
            assert!(known == page.contents, "{} differs: CAROM_ACCEPT=1 writes it anew", path.display());
        }
    });
}

#[test]
fn carom_knows_that_students_may_type_anything() {
    let formats = carom::render::Formats::shipped().unwrap();
    pages(|pages| {
        let page = |format: &str| formats.feedback(format, &pages[1]).unwrap().unwrap();
        let (html, latex) = (page("html").contents, page("latex").contents);
        assert!(!html.contains("<script") && html.contains("&lt;script&gt;alert(1)"), "{html}");
        assert!(!latex.contains(r"\input{") && latex.matches(r"\end{document}").count() == 1, "{latex}");
        for page in [html, latex, page("text").contents] {
            assert!(!page.contains(&"9".repeat(301)), "nobody reads so many figures");
        }
        assert_eq!(page("html").name, "input-etc-passwd-script-alert-1-script.html");
    });
}
