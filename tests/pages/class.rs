//! A small class, marked: a script with a mistake of each kind, explained and followed through, and one as nasty as they come.

use carom::expr::Expr;
use carom::mark::report::{ClassReport, Feedback, MarkReport, Names};
use carom::mark::submissions::{read_overrides, read_rows, sort};
use carom::mark::{AnswerKey, Award, Cause, Evidence, Examiner, MarkedLine, MarkedPart, Place, Profile};
use carom::paper::{Key, compose, key_question};
use carom::{bank, diagnostic::Source, generate};

/// The key of two shipped questions, one of them in parts.
pub fn key() -> AnswerKey {
    let wanted = ["rest/speeds-and-directions", "both-moving/energy-lost-and-impulse"];
    let questions = wanted.into_iter().enumerate().map(|(place, id)| {
        let (_, text) = bank::shipped().find(|(known, _)| *known == id).unwrap();
        let question = bank::read_question(id, &Source::new(id, text)).unwrap();
        let variant = generate::reference(&question).unwrap();
        key_question(&question, &variant, &compose(&question, &variant, place + 1))
    });
    let key = Key::new("shipped".to_owned(), Some(7), questions.collect());
    let key = Key { code: "MPH-UW8".to_owned(), ..key };
    AnswerKey::read(&serde_json::to_string(&key).unwrap()).unwrap()
}

/// What is handed in: names and answers as nasty as they come.
const ROWS: &str = "student,question,part,blank,answer,working
Ada Lovelace,1,,speed of A,2.8 m/s,\"v = 4sin30 = 2
4*4cos30 = 4v + 2w\"
Ada Lovelace,1,,direction of A,43.9°,
Ada Lovelace,1,,speed of B,5.33,
Ada Lovelace,1,,direction of B,over there,
Ada Lovelace,2,b,,,
}\\input{/etc/passwd}<script>alert(1)</script>$&#_^~%,1,,speed of A,\"\\end{document}<b>√39</b> 中文\",
}\\input{/etc/passwd}<script>alert(1)</script>$&#_^~%,1,,speed of B,LONG,
";

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
    for award in &mut part.awards[..2] {
        award.given = true;
        award.note = Some("implied");
        award.feedback = "implied by the speed of A".into();
    }
    let award: &mut Award = &mut part.awards[7];
    award.given = true;
    award.note = Some("follow-through");
    award.feedback = "right from their own component of A".into();
    award.evidence = Some(Evidence { place: Place::Line(1), reading: "v = 4 sin 30°".into() });
    part.own = vec![("A.after.n".parse().unwrap(), Expr::integer(2))];
}

/// Calls with each page of a small class.
pub fn pages(look: impl FnOnce(&[Feedback])) {
    marked(|report| look(&Feedback::of(report)));
}

/// Calls with the report on it.
pub fn report(names: Names, look: impl FnOnce(&ClassReport)) {
    marked(|report| look(&ClassReport::new(report, 1, names)));
}

fn marked(look: impl FnOnce(&MarkReport)) {
    let key = key();
    let rows = ROWS.replace("LONG", &"9".repeat(5000));
    let sorted = sort(&key, read_rows(&Source::new("submissions.csv", rows.as_str())).unwrap());
    assert_eq!(sorted.set_aside, []);
    let overrides =
        Source::new("overrides.csv", "student,question,mark,given,comment\nAda Lovelace,1,A1e,1,seen in the margin\n");
    let overrides = read_overrides(&overrides, &key).unwrap();
    let mut report = MarkReport::new(&sorted.scripts, &Profile::default(), overrides);
    for part in report.scripts.iter_mut().flat_map(|script| &mut script.parts) {
        // What the marker finds is tested elsewhere; here a page has to hold it.
        part.marked.answers.iter_mut().for_each(|answer| answer.causes.clear());
        part.marked.lines.clear();
        part.marked.own.clear();
        for award in part.marked.awards.iter_mut().filter(|award| award.by == Examiner::Marker) {
            (award.given, award.note, award.evidence) = (false, None, None);
            award.feedback.clear();
        }
    }
    explained(&mut report.scripts[0].parts[0].marked);
    look(&report);
}
