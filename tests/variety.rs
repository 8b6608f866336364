//! The shipped bank has variants enough, and dealing them to the end gives every one of them once.

use std::collections::BTreeSet;
use std::sync::Mutex;

use carom::bank::{Bank, Question, StyleName};
use carom::generate::{Deal, End, Variant, enumerate};

/// Two classes of thirty, every pupil with numbers of their own.
const ENOUGH: usize = 60;

fn bank() -> Bank {
    Bank::shipped().unwrap_or_else(|_| panic!("the shipped bank reads"))
}

#[test]
fn carom_knows_sixty_variants_of_every_shipped_question_in_two_styles() {
    let bank = bank();
    let counted: Vec<(&str, Vec<(StyleName, usize)>)> = std::thread::scope(|scope| {
        let count = |question: &Question| {
            let styles = question.styles.iter();
            styles.map(|style| (style.name, Deal::new(question, style, 1).take(ENOUGH).count())).collect()
        };
        let (one, two) = bank.questions.split_at(bank.questions.len() / 2);
        let [one, two] = [one, two].map(|half| {
            scope.spawn(move || half.iter().map(|question| (question.id.as_str(), count(question))).collect::<Vec<_>>())
        });
        [one, two].into_iter().flat_map(|half| half.join().unwrap()).collect()
    });
    assert!(counted.len() >= 17, "only {} questions", counted.len());
    let table: Vec<String> = counted.iter().map(|(id, styles)| format!("{id}: {styles:?}")).collect();
    for (id, styles) in &counted {
        let enough = styles.iter().filter(|(_, count)| *count >= ENOUGH).count();
        assert!(enough >= 2, "{id} has {ENOUGH} variants in {enough} styles only\n{}", table.join("\n"));
    }
}

#[test]
fn carom_deals_a_shipped_style_to_its_end_without_a_repeat() {
    let bank = bank();
    let numbers = |variant: &Variant| format!("{:?}", variant.parameters);
    for (id, style) in [
        ("rest-letters/deflection-from-a-given-angle", StyleName::Exact),
        ("rest/speeds-and-directions", StyleName::Friendly),
    ] {
        let question = bank.find(id).unwrap();
        let style = question.style(style).unwrap();
        let enumerated = Mutex::new(BTreeSet::new());
        let visit = |variant: Variant| {
            assert!(enumerated.lock().unwrap().insert(numbers(&variant)), "{id} enumerated twice: {variant:?}");
        };
        let census = enumerate(question, style, &visit, &|_| {});
        let mut deal = Deal::new(question, style, 11);
        let mut dealt = BTreeSet::new();
        for variant in deal.by_ref() {
            assert!(dealt.insert(numbers(&variant)), "{id} dealt twice: {:?}", variant.parameters);
        }
        let enumerated = enumerated.into_inner().unwrap();
        assert!(enumerated.len() >= ENOUGH, "{id}: {}", enumerated.len());
        assert_eq!(census.fit, enumerated.len() as u64, "{id}");
        assert_eq!(dealt, enumerated, "{id}");
        assert_eq!((deal.end(), deal.examined()), (Some(End::Exhausted), style.size()), "{id}");
    }
}
