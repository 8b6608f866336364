//! Every fault of a template as a teacher sees it: the table here gives `tests/errors/templates/NAME.txt`.
//!
//! `CAROM_ACCEPT=1 cargo test --test templates` writes the expected texts anew; read them before you keep them.

use std::fs;
use std::path::Path;

use carom::bank::Bank;
use carom::diagnostic::{Severity, render_all};
use carom::generate::reference;
use carom::paper::{Paper, compose};
use carom::render::{Formats, RenderFault, TemplateFile};

fn own(path: &str, contents: &str) -> TemplateFile {
    TemplateFile { path: path.into(), place: format!("my-templates/{path}"), contents: contents.into() }
}

/// A paper of two questions, with everything on it that a template may ask for.
fn paper() -> Paper {
    let bank = Bank::shipped().unwrap_or_else(|faults| panic!("{}", render_all(&faults, false)));
    let printed = bank.questions.iter().take(2).enumerate().map(|(index, question)| {
        let variant = reference(question).unwrap_or_else(|_| panic!("{} has no reference numbers", question.id));
        compose(question, &variant, index + 1)
    });
    Paper { title: "Oblique impacts".to_owned(), questions: printed.collect(), ..Paper::default() }
}

const MANIFEST: &str =
    "about = 'x'\nnotation = 'unicode'\ndocuments = [{ file = 'sheet.txt', template = 'sheet.txt' }]\n";

/// A teacher's folder of templates: paths and contents.
type Folder = &'static [(&'static str, &'static str)];

/// Folders with something wrong in them, by the name of the file that says what a teacher is told.
const CASES: [(&str, Folder); 32] = [
    ("unknown-name", &[("html/question-sheet.html", "<h1>{{ title }}</h1>\n<p>{{ scool }}</p>\n")]),
    (
        "unknown-name-where-no-paper-goes",
        &[("html/question-sheet.html", "{% if seed %}{% if titel %}never{% endif %}{% endif %}")],
    ),
    (
        "unknown-name-of-a-question",
        &[(
            "latex/question-sheet.tex",
            "<% for q in questions -%>\n\\textbf{<<q.nummer>>} <<q.mirors>>\n<% endfor %>\n",
        )],
    ),
    (
        "unknown-name-in-an-included-file",
        &[
            (
                "html/question-sheet.html",
                "{% for question in questions %}{% for p in question.parts %}{% include 'part.html' %}{% endfor %}{% endfor %}",
            ),
            ("html/part.html", "<p>{{ p.ask }}</p>\n<p>{{ p.mark }}</p>\n"),
        ],
    ),
    ("unknown-name-in-place-of-a-shipped-file", &[("latex/preamble.tex", "\\documentclass{article}\n<<paper>>")]),
    ("name-of-a-list", &[("html/question-sheet.html", "{{ questions.number }}")]),
    ("name-of-a-word", &[("html/question-sheet.html", "{{ title.text }}")]),
    ("two-names-for-a-list", &[("html/question-sheet.html", "{% for i, question in questions %}{{ i }}{% endfor %}")]),
    ("loop-without-a-loop", &[("html/question-sheet.html", "{{ loop.index }}")]),
    ("unknown-name-of-loop", &[("html/question-sheet.html", "{% for q in questions %}{{ loop.number }}{% endfor %}")]),
    ("unknown-filter", &[("html/question-sheet.html", "{{ title | uper }}\n{{ title | shout }}")]),
    ("unknown-test", &[("html/question-sheet.html", "{% if title is defind %}{% endif %}")]),
    ("unknown-function", &[("html/question-sheet.html", "{{ rang(end=3) }}")]),
    (
        "unknown-template",
        &[
            ("terminal/format.toml", MANIFEST),
            ("terminal/sheet.txt", "{% include 'heads.txt' %}"),
            ("terminal/head.txt", "{{ title }}"),
        ],
    ),
    ("unknown-component", &[("html/question-sheet.html", "{{ <row/> }}")]),
    ("unknown-tag", &[("html/question-sheet.html", "{% fro question in questions %}{% endfor %}")]),
    (
        "circle",
        &[
            ("html/question-sheet.html", "{% include 'part.html' %}"),
            ("html/part.html", "\n{% include 'question-sheet.html' %}"),
        ],
    ),
    (
        "never-closed",
        &[("latex/question-sheet.tex", "<<title>>\n<% for question in questions %>\n<% if seed %>x<% endif %>\n")],
    ),
    ("closes-nothing", &[("html/question-sheet.html", "{{ title }}\n{% endif %}")]),
    ("mark-never-closed", &[("latex/question-sheet.tex", "<<title\n\\section{Questions}\n")]),
    ("broken-expression", &[("latex/question-sheet.tex", "<<title | >>")]),
    ("two-broken-files", &[("html/question-sheet.html", "{{ title + }}"), ("html/mark-scheme.html", "{% if %}")]),
    ("wrong-kind", &[("html/question-sheet.html", "{{ title }}\n{{ questions | upper }}")]),
    ("unknown-key", &[("latex/format.toml", "about = 'x'\nnotatoin = 'latex'\n")]),
    ("unknown-notation", &[("latex/format.toml", "about = 'x'\nnotation = 'latx'\ndocuments = []\n")]),
    ("number-for-a-list", &[("latex/format.toml", "about = 'x'\nnotation = 'latex'\ndocuments = 3\n")]),
    ("no-key", &[("latex/format.toml", "latex\n")]),
    ("missing-key", &[("latex/format.toml", "notation = 'latex'\ndocuments = []\n")]),
    (
        "unfit-documents",
        &[
            (
                "new/format.toml",
                "about = 'x'\nnotation = 'html'\n[[documents]]\nfile = '../x.html'\ntemplate = 'sheat.html'\n",
            ),
            ("new/sheet.html", ""),
        ],
    ),
    (
        "unfit-marks",
        &[(
            "new/format.toml",
            "about = 'x'\nnotation = 'html'\ndocuments = []\n[delimiters]\nvariable = ['<<<', '>>>']\nblock = ['<%', '%>']\ncomment = ['<#', '#>']\n",
        )],
    ),
    ("no-manifest", &[("latx/preamble.tex", "x")]),
    (
        "nothing-uses-it",
        &[
            ("html/stile.css", "x"),
            ("latex/preambel.tex", "x"),
            ("latex/extra.tex", "x"),
            ("preamble.tex", "x"),
            ("letter.txt", "x"),
            ("README.md", "{{ anything }}"),
            ("terminal/format.toml", MANIFEST),
            ("terminal/sheet.txt", "{{ title }}"),
        ],
    ),
];

/// What a teacher is told of a folder, warnings included.
fn told(folder: Folder) -> String {
    let formats = match Formats::with(folder.iter().map(|(path, contents)| own(path, contents))) {
        Ok(formats) => formats,
        Err(fault) => return format!("{fault}\n"),
    };
    assert!(formats.warnings().iter().all(|warning| warning.severity == Severity::Warning));
    let rendered = folder
        .iter()
        .filter_map(|(path, _)| path.split_once('/'))
        .try_for_each(|(format, _)| formats.render(format, &paper()).map(drop));
    let fault = rendered.err().map(|fault| format!("{fault}\n")).unwrap_or_default();
    render_all(formats.warnings(), false) + &fault
}

#[test]
fn carom_tells_a_teacher_what_is_wrong_with_a_template() {
    let accept = std::env::var_os("CAROM_ACCEPT").is_some();
    let texts = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/errors/templates");
    for (name, folder) in CASES {
        let shown = told(folder);
        assert!(!shown.is_empty(), "nothing is wrong with {name}");
        let expected = texts.join(format!("{name}.txt"));
        if accept {
            fs::create_dir_all(&texts).unwrap();
            fs::write(&expected, &shown).unwrap();
        }
        let wanted = fs::read_to_string(&expected).unwrap_or_default();
        assert_eq!(shown, wanted, "{name} differs; see the head of this file");
    }
    let mut listed: Vec<String> = CASES.iter().map(|(name, _)| format!("{name}.txt")).collect();
    let mut there: Vec<String> =
        fs::read_dir(&texts).unwrap().map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    listed.sort();
    there.sort();
    assert_eq!(there, listed);
}

#[test]
fn carom_offers_the_format_that_was_meant() {
    let formats = Formats::shipped().unwrap();
    let told = |format: &str| {
        let fault = formats.render(format, &Paper::default()).unwrap_err();
        (fault.to_string(), fault.help().unwrap_or_default())
    };
    assert_eq!(told("latx"), ("unknown format `latx`".to_owned(), "did you mean `latex`?".to_owned()));
    let (_, help) = told("docx");
    assert!(formats.list().all(|(name, _)| help.contains(&format!("`{name}`"))), "{help}");
}

/// Files of the shipped formats, as a teacher would copy them.
fn shipped() -> Vec<(String, String)> {
    let templates = Path::new(env!("CARGO_MANIFEST_DIR")).join("templates");
    let files = carom::cli::read_templates(&templates).unwrap();
    files.into_iter().filter(|file| file.path.contains('/')).map(|file| (file.path, file.contents)).collect()
}

/// Every so many steps of a walk through the bytes of the shipped templates: an even sample, the same each time.
fn places(contents: &str, count: usize) -> impl Iterator<Item = usize> + '_ {
    (0..count).map(move |step| step * contents.len() / count).filter(|place| contents.is_char_boundary(*place))
}

/// A damaged file gives pages or faults in lines that there are, and no panic.
fn damaged(path: &str, contents: &str, paper: &Paper) {
    let format = path.split('/').next().unwrap_or_default();
    let rendered = Formats::with([own(path, contents)]).and_then(|formats| formats.render(format, paper));
    match rendered {
        Ok(files) => assert!(!files.is_empty()),
        Err(RenderFault::Templates(faults)) => {
            assert!(!faults.is_empty(), "{path}");
            for fault in faults {
                let lines = fault.source.text.split('\n').count();
                assert!((1..=lines).contains(&fault.line()), "{fault}");
                assert!(fault.span.end <= fault.source.text.len(), "{fault}");
            }
        }
        Err(other) => panic!("{path}: {other}"),
    }
}

#[test]
fn carom_bears_a_template_cut_anywhere() {
    let paper = paper();
    for (path, contents) in shipped() {
        for place in places(&contents, SAMPLE) {
            damaged(&path, &contents[..place], &paper);
        }
    }
}

#[test]
fn carom_bears_a_template_with_a_piece_missing() {
    let paper = paper();
    for (path, contents) in shipped() {
        for (step, place) in places(&contents, SAMPLE).enumerate() {
            let rest = &contents[place..];
            let missing = rest.char_indices().nth(1 + step * 7 % 23).map_or(rest.len(), |(length, _)| length);
            damaged(&path, &format!("{}{}", &contents[..place], &rest[missing..]), &paper);
        }
    }
}

/// How many places of each file are tried; more take minutes.
const SAMPLE: usize = 6;
