//! Scripts and the marks they earn: `tests/data/scripts.toml` is the table.

use carom::bank::{StyleName, read_question, shipped};
use carom::diagnostic::Source;
use carom::expr::{Angles, print, read};
use carom::generate::{reference, with_numbers};
use carom::mark::{
    AnswerKey, KeyedQuestion, MarkedPart, PartScript, Profile, Script, from_own_values, mark, mark_each,
};
use carom::paper::{Key, KeyQuestion, compose, key_question};
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    script: Vec<Row>,
}

/// A script for one part of a question with its reference numbers.
#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    /// What it is an example of.
    name: String,
    question: String,
    #[serde(default)]
    part: String,
    /// Answers by the names of their blanks.
    #[serde(default)]
    answers: std::collections::BTreeMap<String, String>,
    /// An answer to the whole part.
    answer: Option<String>,
    #[serde(default)]
    working: String,
    /// What was handed in under earlier parts.
    #[serde(default)]
    before: Vec<Earlier>,
    #[serde(default)]
    profile: Option<String>,
    /// With the question's own numbers in this style, else the one of its reference.
    style: Option<String>,
    /// Numbers of its own in the place of some of the reference.
    #[serde(default)]
    numbers: std::collections::BTreeMap<String, String>,
    /// The codes it earns, in the order of the scheme.
    codes: String,
    /// Tags that must be among the notes of answers, causes and awards.
    #[serde(default)]
    notes: Vec<String>,
    /// For blanks the tag of the likeliest mistake.
    #[serde(default)]
    likeliest: std::collections::BTreeMap<String, String>,
    /// Tags that must not be among them.
    #[serde(default)]
    without: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Earlier {
    part: String,
    #[serde(default)]
    answers: std::collections::BTreeMap<String, String>,
    #[serde(default)]
    working: String,
}

fn keyed(id: &str, style: Option<&str>, numbers: &std::collections::BTreeMap<String, String>) -> KeyedQuestion {
    let (id, text) = shipped().find(|(name, _)| *name == id).unwrap_or_else(|| panic!("no question {id}"));
    let mut question = read_question(id, &Source::new(id, text)).unwrap();
    for (name, number) in question.reference.iter_mut() {
        if let Some(own) = numbers.get(name) {
            *number = read(own, Angles::Degrees).unwrap();
        }
    }
    let style = style.map(|name| question.styles.iter().find(|style| style.name.to_string() == name).unwrap());
    let variant = match style {
        Some(style) => with_numbers(&question, style, &question.reference).unwrap(),
        None => reference(&question).unwrap(),
    };
    read_back(key_question(&question, &variant, &compose(&question, &variant, 1)))
}

/// The question as a marker has it from the key.
fn read_back(keyed: KeyQuestion) -> KeyedQuestion {
    let key = serde_json::to_string(&Key::new("shipped".to_owned(), None, vec![keyed])).unwrap();
    AnswerKey::read(&key).unwrap().papers.remove(0).questions.remove(0)
}

fn part_script(label: &str, answers: &std::collections::BTreeMap<String, String>, working: &str) -> PartScript {
    PartScript {
        label: label.to_owned(),
        answers: answers.iter().map(|(blank, answer)| (Some(blank.clone()), answer.clone())).collect(),
        working: working.lines().map(str::to_owned).collect(),
    }
}

fn script_of(row: &Row) -> Script {
    let mut parts: Vec<PartScript> =
        row.before.iter().map(|earlier| part_script(&earlier.part, &earlier.answers, &earlier.working)).collect();
    let mut own = part_script(&row.part, &row.answers, &row.working);
    own.answers.extend(row.answer.iter().map(|answer| (None, answer.clone())));
    parts.push(own);
    Script { student: "Ann".into(), question: 1, parts }
}

fn marked(row: &Row) -> MarkedPart {
    let question = keyed(&row.question, row.style.as_deref(), &row.numbers);
    let profile = row.profile.as_deref().map_or_else(Profile::default, |name| Profile::named(name).unwrap());
    let found = mark(&question, &script_of(row), &profile);
    found.into_iter().find(|part| part.label == row.part).expect("the part is there")
}

/// Who marks one script after the other remembers what was found, and finds nothing else in the next.
#[test]
fn what_a_script_earns_does_not_hang_on_those_marked_before_it() {
    let table: Table = toml::from_str(include_str!("data/scripts.toml")).unwrap();
    let plain = |row: &&Row| row.style.is_none() && row.profile.is_none() && row.numbers.is_empty();
    let mut by_question: std::collections::BTreeMap<&str, Vec<Script>> = Default::default();
    for row in table.script.iter().filter(plain) {
        by_question.entry(&row.question).or_default().push(script_of(row));
    }
    for (id, mut scripts) in by_question {
        let question = keyed(id, None, &Default::default());
        let bare = scripts.iter().map(without_working).collect::<Vec<Script>>();
        scripts.splice(0..0, bare);
        scripts.dedup();
        let first = mark_each(&question, &scripts, &Profile::default());
        let mut last = mark_each(&question, scripts.iter().rev(), &Profile::default());
        last.reverse();
        for (script, (first, last)) in scripts.iter().zip(first.iter().zip(&last)) {
            assert_eq!(first, last, "{id}: {script:?}");
        }
    }
}

fn without_working(script: &Script) -> Script {
    let bare = |part: &PartScript| PartScript { working: Vec::new(), ..part.clone() };
    Script { parts: script.parts.iter().map(bare).collect(), ..script.clone() }
}

/// The equations of the solution from the student's own values.
fn gone_on_from(row: &Row) -> Vec<String> {
    let question = keyed(&row.question, row.style.as_deref(), &row.numbers);
    let part = question.parts.iter().find(|part| part.label == row.part).expect("the part is there");
    let lines = from_own_values(&question, part, &marked(row).own);
    lines.iter().flat_map(|line| line.equations.iter().map(print::plain)).collect()
}

/// Everything that was found, to see why a row fails.
fn story(part: &MarkedPart) -> String {
    let mut story = String::new();
    for answer in &part.answers {
        let judgement = &answer.judgement;
        story +=
            &format!("  {} = {:?}: {} {:?}\n", answer.name, answer.typed, judgement.verdict.name(), judgement.note);
        for cause in &answer.causes {
            story += &format!("    {}\n", cause.tag);
        }
    }
    for line in &part.lines {
        story += &format!("  | {} | {:?} | {}\n", line.typed, line.reading, line.role);
    }
    for award in &part.awards {
        story +=
            &format!("  {} {} {:?} {:?} {}\n", award.id, award.printed(), award.note, award.evidence, award.feedback);
    }
    story
}

#[test]
fn every_script_of_the_table_earns_its_marks() {
    let table: Table = toml::from_str(include_str!("data/scripts.toml")).unwrap();
    let mut wrong = String::new();
    for row in &table.script {
        let part = marked(row);
        let codes: Vec<String> = part.awards.iter().map(|award| award.printed()).collect();
        let notes: Vec<&str> = part
            .answers
            .iter()
            .flat_map(|answer| {
                answer.judgement.note.into_iter().chain(answer.causes.iter().map(|cause| cause.tag.as_str()))
            })
            .chain(part.awards.iter().filter_map(|award| award.note))
            .collect();
        let missing: Vec<&String> = row.notes.iter().filter(|note| !notes.contains(&note.as_str())).collect();
        let unwanted: Vec<&String> = row.without.iter().filter(|note| notes.contains(&note.as_str())).collect();
        let likeliest = |blank: &str| {
            let answer = part.answers.iter().find(|answer| answer.name == blank)?;
            answer.causes.first().map(|cause| cause.tag.as_str())
        };
        let is_other = |(blank, tag): (&String, &String)| likeliest(blank) != Some(tag.as_str());
        if row.likeliest.iter().any(is_other)
            || codes.join(" ") != row.codes
            || !missing.is_empty()
            || !unwanted.is_empty()
        {
            wrong += &format!(
                "{}\n  earns  {}\n  not    {}\n  missing {missing:?}, unwanted {unwanted:?}\n{}\n",
                row.name,
                codes.join(" "),
                row.codes,
                story(&part)
            );
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn the_rest_is_solved_again_from_the_values_that_the_student_found() {
    let row = Row {
        name: String::new(),
        question: "rest/speeds-and-directions".into(),
        part: String::new(),
        answers: Default::default(),
        answer: None,
        working: "v = 2.69\nw = 3.08".into(),
        before: Vec::new(),
        profile: None,
        style: None,
        numbers: Default::default(),
        codes: String::new(),
        notes: Vec::new(),
        likeliest: Default::default(),
        without: Vec::new(),
    };
    let lines = gone_on_from(&row);
    // Only what is wrong is followed: w is right.
    assert_eq!(lines[0], "v = 2.69");
    assert!(lines.contains(&"s_A = sqrt(2.69^2 + 2^2)".to_owned()), "{lines:?}");
    assert!(lines.contains(&"s_A ~ 3.35".to_owned()), "{lines:?}");
    assert_eq!(gone_on_from(&Row { working: "v = 1.92".into(), ..row }), [""; 0]);
}

#[test]
fn the_rest_is_solved_again_in_the_directions_of_the_solution() {
    let table: Table = toml::from_str(include_str!("data/scripts.toml")).unwrap();
    let name = "what follows at a wall from the student's own component shows the method";
    let row = table.script.iter().find(|row| row.name == name).unwrap();
    // Away from the wall is positive, as in the worked solution.
    assert_eq!(gone_on_from(row)[0], "v = 2.5");
}

#[test]
fn the_rest_is_solved_again_from_a_velocity_as_one_vector() {
    let table: Table = toml::from_str(include_str!("data/scripts.toml")).unwrap();
    let gone_on = |name: &str| gone_on_from(table.script.iter().find(|row| row.name == name).unwrap());
    let lines = gone_on("a wrong vector after a wall is gone on from as a vector");
    assert_eq!(lines[0], "v_A = [4, 2]");
    assert!(lines.contains(&"cos(delta) = 4/(2*sqrt(13)*2*sqrt(5))".to_owned()), "{lines:?}");
    // What comes of the right value of a letter is right.
    assert_eq!(gone_on("the velocity that a letter leads to is right once the letter has been found"), [""; 0]);
}

/// From nought, from the wrong way and from what no sphere can do: something is written, or nothing.
#[test]
fn the_rest_is_solved_again_from_values_that_cannot_be() {
    let question = keyed("rest/speeds-and-directions", None, &Default::default());
    for (written, is_solved) in [("0", true), ("-1", true), ("1000000", true), ("10^30", false), ("u", false)] {
        let own = [("A.after.n".parse().unwrap(), read(written, Angles::Degrees).unwrap())];
        let lines = from_own_values(&question, &question.parts[0], &own);
        let begins = lines.first().map(|line| print::text_unicode(&line.words));
        // What is too large to be worked out, or is no letter of the question, is gone on from by nobody.
        let expected = is_solved.then(|| "You have:".to_owned());
        assert_eq!(begins, expected, "{written}");
    }
}

/// The tags of the mistakes that are named for a blank.
fn causes(row: &Row, blank: &str) -> Vec<String> {
    let answers = marked(row).answers.into_iter().filter(|answer| answer.name == blank);
    answers.flat_map(|answer| answer.causes).map(|cause| cause.tag).collect()
}

#[test]
fn a_slip_is_named_only_where_the_working_does_not_speak_against_it() {
    let tags = |working: &str| {
        let row = Row {
            question: "rest/speeds-and-directions".into(),
            answers: [("speed of B".to_owned(), "2.31".to_owned())].into(),
            working: working.into(),
            ..Row::default()
        };
        causes(&row, "speed of B")
    };
    let omitted = "masses-omitted".to_owned();
    assert!(tags("").contains(&omitted));
    assert!(tags("4cos30 = v + w\nw - v = 4cos30/3\nw = 2.31").contains(&omitted));
    assert_eq!(tags("4*4cos30 = 4v + 2w\nw - v = 4cos30/3\nw = 2.31"), ["arithmetic"]);
}

/// A line that has a sign wrong denies every mistake whose value comes of the right equation.
#[test]
fn a_sign_that_a_line_has_wrong_is_not_another_mistake() {
    let tags = |working: &str| {
        let row = Row {
            question: "direct/restitution-from-one-speed".into(),
            part: "a".into(),
            answers: [("speed of B".to_owned(), "2".to_owned())].into(),
            working: working.into(),
            ..Row::default()
        };
        causes(&row, "speed of B")
    };
    assert_eq!(tags(""), ["other-sphere"]);
    assert_eq!(tags("8 - 2 × 1 = -2 + 2w"), ["other-sphere"]);
    assert!(tags("8 - 2 × 1 = 2 + 2w\nw = 2").is_empty());
}

#[test]
fn an_answer_for_a_number_that_was_copied_wrongly_is_told_what_else_is_amiss_with_it() {
    let working = "5sin30 = 2.5\n4(5cos30) = 4v + 2w\nw - v = 5cos30/3\nv = 2.4056\nw = 3.849";
    for (style, expected) in
        [("calculator", "copied it."), ("exact", "right as a decimal, but the exact value is wanted.")]
    {
        let row = Row {
            question: "rest/speeds-and-directions".into(),
            answers: [("speed of A".to_owned(), "3.47".to_owned())].into(),
            working: working.into(),
            style: Some(style.into()),
            ..Row::default()
        };
        let answer = marked(&row).answers.remove(0).judgement;
        assert_eq!(answer.note, Some("number-misread"));
        assert!(answer.feedback.ends_with(expected), "{}", answer.feedback);
    }
}

#[test]
fn what_is_solved_again_starts_from_a_speed_as_the_velocity_along_the_line() {
    let table: Table = toml::from_str(include_str!("data/scripts.toml")).unwrap();
    let row = table.script.iter().find(|row| row.name.starts_with("a wrong speed taken into")).unwrap();
    assert_eq!(gone_on_from(row)[0], "w = 9.3");
}

/// `2√2` is asked for in exact form on one sheet and to three figures on another; `2.83` is right on the second alone.
#[test]
fn figures_for_an_exact_speed_lose_its_mark_in_the_style_that_asks_for_exact_form() {
    let (id, text) = shipped().find(|(name, _)| *name == "rest/speeds-and-directions").unwrap();
    let question = read_question(id, &Source::new(id, text)).unwrap();
    let answers = [
        ("speed of A", "2.78"),
        ("direction of A", "46.1 degrees to the line of centres"),
        ("speed of B", "16sqrt3/9"),
        ("direction of B", "along the line of centres"),
    ];
    for (style, expected) in [(StyleName::Exact, Some("exact-wanted")), (StyleName::Calculator, None)] {
        let variant = with_numbers(&question, question.style(style).unwrap(), &question.reference).unwrap();
        let printed = compose(&question, &variant, 1);
        let key = read_back(key_question(&question, &variant, &printed));
        let answers = answers.map(|(blank, answer)| (Some(blank.to_owned()), answer.to_owned())).into();
        let parts = vec![PartScript { label: String::new(), answers, working: Vec::new() }];
        let script = Script { student: "Ann".into(), question: 1, parts };
        let part = mark(&key, &script, &Profile::default()).remove(0);
        assert_eq!(part.answers[0].judgement.note, expected, "{style}\n{}", story(&part));
        let lost: Vec<&str> = part.awards.iter().filter(|award| !award.given).map(|award| award.id.as_str()).collect();
        assert_eq!(lost, if expected.is_some() { vec!["A1e"] } else { vec![] }, "{style}\n{}", story(&part));
        // The printed scheme says it as the key does.
        let row = printed.parts[0].scheme.iter().find(|row| row.id == "A1e").unwrap();
        assert_eq!(print::text_unicode(&row.note).contains("awrt 2.78"), expected.is_none(), "{style}");
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Slips {
    question: Vec<Slipping>,
}

/// A question, and the slips that lead to a value of one of its blanks.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Slipping {
    id: String,
    #[serde(default)]
    part: String,
    blank: String,
    #[serde(default)]
    numbers: std::collections::BTreeMap<String, String>,
    /// Working without a slip.
    right: String,
    /// Working by the tag of its slip.
    slips: std::collections::BTreeMap<String, String>,
    /// What else is named, by the tag of the slip.
    #[serde(default)]
    also: std::collections::BTreeMap<String, Vec<String>>,
}

#[test]
fn each_slip_is_named_by_the_working_where_no_answer_is_filled_in() {
    let table: Slips = toml::from_str(include_str!("data/slips-by-working.toml")).unwrap();
    let mut faults = Vec::new();
    for question in &table.question {
        let named = |working: &str| {
            let row = Row {
                question: question.id.clone(),
                part: question.part.clone(),
                working: working.replace("; ", "\n"),
                numbers: question.numbers.clone(),
                ..Row::default()
            };
            let mut named = causes(&row, &question.blank);
            named.sort();
            (named, story(&marked(&row)))
        };
        let right = ("", &question.right);
        for (tag, working) in question.slips.iter().map(|(tag, working)| (&**tag, working)).chain([right]) {
            let (found, story) = named(working);
            let also = question.also.get(tag).into_iter().flatten().map(String::as_str);
            let mut expected: Vec<&str> = also.chain((!tag.is_empty()).then_some(tag)).collect();
            expected.sort_unstable();
            if found != expected {
                faults.push(format!("{}: {working}\n  named {found:?}, and not {expected:?}\n{story}", question.id));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
