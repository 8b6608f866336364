//! The LaTeX pages as pdflatex reads them; left out, and said so, where there is no pdflatex.

use std::fs;
use std::process::Command;

use carom::expr::{Expr, Text};
use carom::paper::{Paper, WorkingLine};
use carom::render::Formats;

/// Long enough to break pages, with a hostile title and equations too wide for their line.
fn strained() -> Paper {
    let mut paper = super::paper::paper();
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
        scheme.scheme[0].equation = Some(equation.clone());
        scheme.working.push(WorkingLine { words: Text::words("Hence:"), equations: vec![equation], label: Some(7) });
    }
    paper
}

#[test]
fn carom_knows_latex_that_pdflatex_sets_within_the_margins() {
    let folder = std::env::temp_dir().join(format!("carom-pages-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    for rendered in Formats::shipped().unwrap().render("latex", &strained()).unwrap() {
        fs::write(folder.join(&rendered.name), &rendered.contents).unwrap();
        let run =
            Command::new("pdflatex").args(["-interaction=nonstopmode", &rendered.name]).current_dir(&folder).output();
        let Ok(run) = run else {
            eprintln!("left out: there is no pdflatex here");
            break;
        };
        let log = String::from_utf8_lossy(&run.stdout).into_owned();
        let faults: Vec<&str> = log
            .lines()
            .filter(|line| line.starts_with('!') || line.contains("Overfull") || line.contains("Warning"))
            .collect();
        assert!(faults.is_empty() && run.status.success(), "{}: {faults:#?}", rendered.name);
    }
    fs::remove_dir_all(&folder).unwrap();
}
