//! The pages as pdflatex and a browser set them: the shipped questions, and a paper that strains every line.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use carom::bank::Bank;
use carom::diagnostic::render_all;
use carom::expr::{Expr, Text};
use carom::generate::reference;
use carom::paper::{Dealer, Paper, WorkingLine, compose};
use carom::render::{Formats, RenderedFile};

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

/// Every shipped question with its own numbers, and then with fresh ones in each style that it offers.
fn whole_bank() -> Paper {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let mut paper = Paper {
        title: "Every question".into(),
        school: "Riverside Sixth Form".into(),
        date: "12 March 2027".into(),
        seed: Some(7),
        ..Paper::default()
    };
    let mut add = |question, variant: &_| {
        let number = paper.questions.len() + 1;
        paper.questions.push(compose(question, variant, number));
    };
    for question in &bank.questions {
        add(question, &reference(question).unwrap_or_else(|_| panic!("{}: reference", question.id)));
    }
    for question in &bank.questions {
        for style in &question.styles {
            let variant = Dealer::new(7, Some(style.name)).next(question);
            add(question, &variant.unwrap_or_else(|| panic!("{} {}", question.id, style.name.name())));
        }
    }
    assert!(paper.questions.len() >= 34, "{} questions", paper.questions.len());
    paper
}

/// A folder of its own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn rendered(format: &str, paper: &Paper) -> Vec<RenderedFile> {
    Formats::shipped().unwrap().render(format, paper).unwrap()
}

fn run(command: &mut Command) -> Output {
    match command.output() {
        Ok(output) => output,
        Err(error) => panic!("{:?} cannot be run: {error}", command.get_program()),
    }
}

/// What pdflatex has against a file, set twice so that it knows its own pages.
fn set(folder: &Path, file: &RenderedFile) -> Vec<String> {
    fs::write(folder.join(&file.name), &file.contents).unwrap();
    let mut pdflatex = Command::new("pdflatex");
    // unbroken lines, so that each complaint is one
    pdflatex.env("max_print_line", "1000").args(["-interaction=nonstopmode", &file.name]).current_dir(folder);
    run(&mut pdflatex);
    let output = run(&mut pdflatex);
    let log = String::from_utf8_lossy(&output.stdout);
    let complaints = log.lines().filter(|line| is_complaint(line)).map(|line| placed(line, file));
    let failed = (!output.status.success()).then(|| format!("{}: pdflatex failed", file.name));
    complaints.chain(failed).collect()
}

/// An error, a warning, or a line that is wider than its place by more than the eye forgives.
fn is_complaint(line: &str) -> bool {
    const FORGIVEN: f64 = 2.0;
    if let Some(rest) = line.strip_prefix(r"Overfull \hbox (") {
        return rest
            .split("pt")
            .next()
            .and_then(|width| width.parse::<f64>().ok())
            .is_none_or(|width| width > FORGIVEN);
    }
    line.starts_with('!') || line.contains("Overfull") || line.contains("Warning")
}

/// A complaint with the last question of the shipped bank before the line that it is about.
fn placed(complaint: &str, file: &RenderedFile) -> String {
    let number = |words: &str| words.split(|letter: char| !letter.is_ascii_digit()).next()?.parse().ok();
    let line: Option<usize> = complaint.split("at lines ").nth(1).and_then(number);
    let above: Vec<&str> = file.contents.lines().take(line.unwrap_or(0)).collect();
    let question = above.iter().rev().find_map(|line| {
        let id = carom::bank::shipped().map(|(id, _)| id).find(|id| line.contains(id))?;
        Some(format!(" in {id}"))
    });
    format!("{}{}: {complaint}", file.name, question.unwrap_or_default())
}

#[test]
fn carom_knows_latex_that_pdflatex_sets_within_the_margins() {
    for (name, paper) in [("latex-strained", strained()), ("latex-bank", whole_bank())] {
        let folder = folder(name);
        let complaints: Vec<String> = rendered("latex", &paper).iter().flat_map(|file| set(&folder, file)).collect();
        assert!(complaints.is_empty(), "{name}:\n{}", complaints.join("\n"));
    }
}

/// The browser that `.ci/run` has made sure of.
fn browser() -> &'static str {
    let known = ["google-chrome", "chromium", "chromium-browser"];
    let answers =
        |name: &&str| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success());
    known.into_iter().find(answers).expect("there is no Chromium here")
}

/// How far the contents of a page reach, and how wide the window is: the page says it of itself.
fn widths(folder: &Path, file: &RenderedFile) -> (u32, u32) {
    let measured = "<script>{ const page = document.documentElement; \
                    page.dataset.widths = `${page.scrollWidth} ${page.clientWidth}`; }</script></body>";
    let path = folder.join(&file.name);
    fs::write(&path, file.contents.replace("</body>", measured)).unwrap();
    let mut chromium = Command::new(browser());
    chromium.args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=900,1200"]);
    chromium.arg(format!("--user-data-dir={}", folder.join("profile").display()));
    chromium.arg("--dump-dom").arg(format!("file://{}", path.display()));
    let output = run(&mut chromium);
    let page = String::from_utf8_lossy(&output.stdout);
    let said = page.split("data-widths=\"").nth(1).and_then(|rest| rest.split('"').next()?.split_once(' '));
    let (reach, window) = said.unwrap_or_else(|| panic!("{}: {}", file.name, String::from_utf8_lossy(&output.stderr)));
    (reach.parse().unwrap(), window.parse().unwrap())
}

#[test]
fn carom_knows_html_that_a_browser_sets_within_the_window() {
    for (name, paper) in [("html-strained", strained()), ("html-bank", whole_bank())] {
        let folder = folder(name);
        for file in rendered("html", &paper) {
            let (reach, window) = widths(&folder, &file);
            assert!(window > 800 && reach <= window, "{name}/{}: {reach} of {window} pixels", file.name);
        }
    }
}

#[test]
fn a_complaint_of_pdflatex_is_seen_and_placed() {
    assert!(is_complaint(r"Overfull \hbox (2.5pt too wide) in paragraph at lines 3--4"));
    assert!(!is_complaint(r"Overfull \hbox (1.5pt too wide) in paragraph at lines 3--4"));
    assert!(is_complaint("LaTeX Warning: There were undefined references."));
    assert!(is_complaint("! Undefined control sequence."));
    assert!(!is_complaint("Underfull \\hbox (badness 10000) in paragraph at lines 3--4"));
    let contents = "\\begin{document}\n% rest/speeds-and-directions\nwords\n% backwards/speed\n".to_owned();
    let file = RenderedFile { name: "sheet.tex".into(), contents };
    let told = placed(r"Overfull \hbox (9.0pt too wide) in paragraph at lines 3--3", &file);
    assert!(told.starts_with("sheet.tex in rest/speeds-and-directions: Overfull"), "{told}");
}
