//! Sheet codes: what they hold comes back, no slip of the fingers goes unnoticed, and neither does an edited bank.

use std::fs;
use std::path::{Path, PathBuf};

use carom::bank::{Contents, Question};
use carom::generate::{Deal, Variant, reference};
use carom::paper::{CodeFault, Dealer, Sheet, SheetCode, choose_count};

const DIGITS: &str = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";

fn questions(contents: &Contents, ids: impl IntoIterator<Item = String>) -> Vec<Question> {
    let question = |id: String| {
        let heading = contents.headings.iter().find(|heading| heading.id == id).unwrap();
        heading.question().unwrap_or_else(|faults| panic!("{id}: {faults:?}"))
    };
    ids.into_iter().map(question).collect()
}

/// A sheet of so many questions.
fn sheet(contents: &Contents, count: usize, seed: u64) -> Sheet {
    let headings: Vec<_> = contents.headings.iter().collect();
    let ids = choose_count(&headings, count, seed).into_iter().map(|heading| heading.id.clone());
    let questions = questions(contents, ids);
    let mut dealer = Dealer::new(seed, None);
    let variants: Vec<Variant> = questions.iter().map(|question| dealer.next(question).unwrap()).collect();
    Sheet::new(contents, questions.iter().zip(&variants))
}

/// Codes of every length that there is: of one reference question, of one to nine questions, and a name.
fn codes(contents: &Contents) -> Vec<String> {
    let first = questions(contents, [contents.headings[0].id.clone()]);
    let numbers = reference(&first[0]).unwrap();
    let smallest = Sheet::new(contents, [(&first[0], &numbers)]);
    let each = (1..=9).chain([20]).map(|count| sheet(contents, count, count as u64));
    [smallest].into_iter().chain(each).map(|sheet| sheet.code.to_string()).collect()
}

#[test]
fn no_character_can_be_mistyped_and_no_two_neighbours_exchanged() {
    let codes = codes(&Contents::shipped());
    let (shortest, longest) = (codes.iter().map(String::len).min(), codes.iter().map(String::len).max());
    assert!(shortest < Some(8) && longest > Some(40), "{codes:?}");
    let mut slips = 0;
    for code in &codes {
        let right: Vec<char> = code.chars().filter(|c| *c != '-').collect();
        assert!(SheetCode::read(&right.iter().collect::<String>()).is_ok());
        for place in 0..right.len() {
            let mut wrong = right.clone();
            for digit in DIGITS.chars().filter(|digit| *digit != right[place]) {
                wrong[place] = digit;
                let read = SheetCode::read(&wrong.iter().collect::<String>());
                assert_eq!(read, Err(CodeFault::Mistyped), "{code}: `{digit}` at {place}");
                slips += 1;
            }
            let mut wrong = right.clone();
            if place > 0 && right[place] != right[place - 1] {
                wrong.swap(place, place - 1);
                let read = SheetCode::read(&wrong.iter().collect::<String>());
                assert_eq!(read, Err(CodeFault::Mistyped), "{code}: {place} exchanged");
                slips += 1;
            }
        }
    }
    assert!(slips > 5000, "{slips}");
}

#[test]
fn a_code_may_be_typed_in_capitals_or_not_with_blanks_or_not_and_with_letters_for_digits() {
    let contents = Contents::shipped();
    for seed in 0..40 {
        let code = sheet(&contents, 1, seed).code;
        let printed = code.to_string();
        assert!(!printed.contains(['O', 'I', 'L', 'U']), "{printed}");
        let typed = [
            printed.to_lowercase(),
            printed.replace('-', " "),
            printed.replace('-', ""),
            printed.replace('0', "O").replace('1', "I"),
            printed.replace('0', "o").replace('1', "l"),
            format!("  {} \n", printed.replace('-', "–")),
        ];
        for typed in typed {
            assert_eq!(SheetCode::read(&typed).as_ref(), Ok(&code), "{typed:?}");
        }
    }
    for (typed, fault) in [
        ("", CodeFault::Short),
        ("1234", CodeFault::Short),
        ("U2345678", CodeFault::Character('U')),
        ("KV7-3QX-ß", CodeFault::Character('ß')),
        (&"1".repeat(41), CodeFault::Long),
    ] {
        assert_eq!(SheetCode::read(typed), Err(fault), "{typed:?}");
    }
}

#[test]
fn a_code_gives_back_every_question_in_every_style_and_every_sheet() {
    let contents = Contents::shipped();
    let again = |sheet: &Sheet| {
        let code = SheetCode::read(&sheet.code.to_string()).unwrap();
        let again = Sheet::from_code(&contents, &code).unwrap_or_else(|fault| panic!("{code}: {fault}"));
        assert!(again.printed == sheet.printed, "{code}");
        assert_eq!(serde_json::to_string(&again.keyed).unwrap(), serde_json::to_string(&sheet.keyed).unwrap());
    };
    let all = questions(&contents, contents.headings.iter().map(|heading| heading.id.clone()));
    for question in &all {
        for style in &question.styles {
            let deal = Deal::new(question, style, 3);
            deal.take(2).for_each(|variant| again(&Sheet::new(&contents, [(question, &variant)])));
        }
    }
    for count in [1, 2, 6, 8] {
        again(&sheet(&contents, count, 11));
    }
    let numbers: Vec<Variant> = all.iter().map(|question| reference(question).unwrap()).collect();
    for (some, numbers) in all.chunks(6).zip(numbers.chunks(6)) {
        again(&Sheet::new(&contents, some.iter().zip(numbers)));
    }
}

#[test]
fn a_sheet_of_too_many_questions_has_a_name_that_says_so() {
    let contents = Contents::shipped();
    let long = sheet(&contents, 20, 1).code;
    assert!(!long.holds_the_sheet() && long.to_string().len() == 9, "{long}");
    assert_eq!(Sheet::from_code(&contents, &long).unwrap_err(), CodeFault::NamesOnly);
    assert_ne!(long, sheet(&contents, 20, 2).code);
}

/// A bank of one's own: the shipped question 5C-2 and another, the first with pieces replaced.
fn bank(name: &str, from: &str, to: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("codes-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join("rest")).unwrap();
    for id in ["rest/speeds-and-directions", "rest/heavier-sphere-struck"] {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("question_bank/{id}.toml"));
        let text = fs::read_to_string(file).unwrap();
        assert!(!id.ends_with("directions") || text.contains(from), "{from}");
        let text = if id.ends_with("directions") { text.replacen(from, to, 1) } else { text };
        fs::write(folder.join(format!("{id}.toml")), text).unwrap();
    }
    folder
}

#[test]
fn an_edited_bank_is_noticed_and_an_edited_comment_does_no_harm() {
    let contents = Contents::read_folder(&bank("as-shipped", "mA", "mA")).unwrap();
    let code = {
        let question = &questions(&contents, ["rest/speeds-and-directions".to_owned()])[0];
        let style = question.styles.iter().find(|style| style.name.name() == "exact").unwrap();
        let variant = Deal::new(question, style, 5).next().unwrap();
        Sheet::new(&contents, [(question, &variant)]).code
    };
    assert!(Sheet::from_code(&contents, &code).is_ok());
    let edits = [
        ("words", "smooth horizontal plane", "smooth horizontal table", false),
        ("what-is-asked", "Find the speed", "Find exactly the speed", false),
        ("numbers", "u     = \"2..8\"", "u     = \"3..9\"", false),
        ("another-value", "mA = \"1..6\"", "mA = \"1..7\"", false),
        ("mark", "{ code = \"B1\", for = \"perpendicular\" },", "", false),
        ("acceptance", "_loc_deg\", accept = \"awrt 3sf\"", "_loc_deg\", accept = \"awrt 2sf\"", false),
        ("exact-form", "exact = [\"speed of *A*\", ", "exact = [", false),
        ("comment", "# A is heavy enough", "# A is quite heavy enough", true),
        ("title", "A strikes B at rest: speeds", "A strikes B: speeds", true),
    ];
    for (name, from, to, holds) in edits {
        let edited = Contents::read_folder(&bank(name, from, to)).unwrap();
        let opened = Sheet::from_code(&edited, &code);
        let expected = if holds { None } else { Some(CodeFault::OtherBank) };
        assert_eq!(opened.err(), expected, "{name}");
    }
    assert_eq!(Sheet::from_code(&Contents::shipped(), &code).err(), Some(CodeFault::OtherBank));
}

#[test]
fn whatever_has_a_right_check_digit_leads_to_its_sheet_or_to_none() {
    let contents = Contents::shipped();
    let mut state: u64 = 7;
    let mut read = 0;
    for length in (5..40).cycle().take(140) {
        let letters = (0..length).map(|_| {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            DIGITS.as_bytes()[(state >> 59) as usize] as char
        });
        let text: String = letters.collect();
        // One of the 32 last characters agrees.
        let codes = DIGITS.chars().filter_map(|last| SheetCode::read(&format!("{text}{last}")).ok());
        for code in codes {
            let _ = Sheet::from_code(&contents, &code).map(|sheet| assert_eq!(sheet.code, code));
            read += 1;
        }
    }
    assert_eq!(read, 140);
}
