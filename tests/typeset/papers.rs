//! The papers that are set: the shipped questions, a paper that strains every line, and every style many times over.

use carom::bank::{Bank, Question, Style};
use carom::diagnostic::render_all;
use carom::expr::{Expr, Text};
use carom::generate::{Deal, End, reference};
use carom::paper::{Dealer, Edition, Paper, WorkingLine, compose};

/// The questions that Carom comes with.
pub fn bank() -> Bank {
    Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)))
}

/// A paper with all that its head can have, and no questions yet.
pub fn empty() -> Paper {
    Paper {
        title: "Every question".into(),
        school: "Riverside Sixth Form".into(),
        date: "12 March 2027".into(),
        // As long as codes come.
        code: "887N-W5M5-RTNW-QAM1-4SV7-SP4A-99KX-2T6B-C0DE-7YHG".into(),
        ..Paper::default()
    }
}

/// Every shipped question with its own numbers.
pub fn reference_set() -> Paper {
    let mut paper = empty();
    for question in &bank().questions {
        let variant = reference(question).unwrap_or_else(|_| panic!("{}: reference", question.id));
        paper.questions.push(compose(question, &variant, paper.questions.len() + 1));
    }
    paper
}

/// The reference set, and then every question with fresh numbers in each style that it offers.
pub fn whole_bank() -> Paper {
    let mut paper = reference_set();
    for question in &bank().questions {
        for style in &question.styles {
            let variant = Dealer::new(7, Some(style.name)).next(question);
            let variant = variant.unwrap_or_else(|| panic!("{} {}", question.id, style.name.name()));
            paper.questions.push(compose(question, &variant, paper.questions.len() + 1));
        }
    }
    assert!(paper.questions.len() >= 34, "{} questions", paper.questions.len());
    paper
}

/// The ways in which a paper can be set.
pub fn editions() -> [(&'static str, Edition); 4] {
    let plain = Edition::default();
    [
        ("plain", plain),
        ("large-print", Edition { large_print: true, ..plain }),
        ("answer-space", Edition { answer_space: true, ..plain }),
        ("large-print-answer-space", Edition { large_print: true, answer_space: true, ..plain }),
    ]
}

/// Long enough to break pages, with a hostile title and equations too wide for their line.
pub fn strained() -> Paper {
    let mut paper = super::by_hand::paper();
    let few = paper.questions.clone();
    for number in 4..=9 {
        let mut question = few[number % 3].clone();
        question.number = number;
        question.stem.push(question.stem[0].clone());
        paper.questions.push(question);
    }
    paper.title = r"}\input{/etc/passwd} <b>&#_^~%\ [2cm]* Žluťoučký kůň 中文 Łódź “quoted” ?`".repeat(2);
    let sum = |count: i64| {
        Expr::Sum((1..=count).map(|n| Expr::Product(vec![Expr::integer(n), Expr::name("alpha")])).collect())
    };
    let scheme = &mut paper.questions[0].parts[0];
    for (left, right) in [(2, 30), (30, 2), (12, 12)] {
        let equation = Expr::equation(sum(left), sum(right));
        scheme.scheme[0].equations = vec![equation.clone()];
        scheme.working.push(WorkingLine { words: Text::words("Hence:"), equations: vec![equation], label: Some(7) });
    }
    paper
}

/// A paper of many variants, and what each of its questions is: `rest/speeds friendly 17`.
pub struct Batch {
    /// The paper.
    pub paper: Paper,
    /// The names of its questions, in order.
    pub names: Vec<String>,
    /// How many variants each style gave, and whether that is all there are.
    pub styles: Vec<(String, usize, bool)>,
}

/// A question in all its styles, so many variants of each or as many as there are.
pub fn batch(question: &Question, most: usize) -> Batch {
    let mut batch = Batch { paper: empty(), names: Vec::new(), styles: Vec::new() };
    batch.paper.title.clone_from(&question.id);
    for style in &question.styles {
        let named = format!("{} {}", question.id, style.name.name());
        let before = batch.names.len();
        let all = add(question, style, most, &mut batch);
        batch.styles.push((named, batch.names.len() - before, all));
    }
    batch
}

/// Adds variants of a style; are there no more?
fn add(question: &Question, style: &Style, most: usize, batch: &mut Batch) -> bool {
    let mut deal = Deal::new(question, style, 1);
    for variant in deal.by_ref().take(most) {
        batch.names.push(format!("{} {} {}", question.id, style.name.name(), variant.index.unwrap_or_default()));
        batch.paper.questions.push(compose(question, &variant, batch.names.len()));
    }
    deal.end() == Some(End::Exhausted)
}
