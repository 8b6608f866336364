//! Pages as files: what a paper composed by hand becomes in every shipped format, byte for byte.
//!
//! `CAROM_ACCEPT=1 cargo test --test pages` writes the files anew; read them before you commit them.

mod accessibility;
#[path = "../typeset/chromium.rs"]
mod chromium;
mod class;
mod families;
mod feedback;
#[path = "../typeset/on_both.rs"]
mod on_both;
mod paper;
mod report;

use std::fs;
use std::path::{Path, PathBuf};

use carom::paper::Paper;
use carom::render::{Formats, RenderedFile, TemplateFile};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/pages")
}

fn own(path: &str, contents: &str) -> TemplateFile {
    TemplateFile { path: path.into(), place: format!("mine/{path}"), contents: contents.into() }
}

fn file<'a>(files: &'a [RenderedFile], name: &str) -> &'a str {
    &files.iter().find(|file| file.name == name).expect(name).contents
}

#[test]
fn carom_knows_that_the_same_paper_is_the_same_pages() {
    let formats = Formats::shipped().unwrap();
    let accept = std::env::var_os("CAROM_ACCEPT").is_some();
    let mut differing = Vec::new();
    for (format, _) in formats.list() {
        let of_class = formats.class(format, &class()).unwrap().unwrap();
        let key = of_class.into_iter().filter(|file| file.name.starts_with("teachers-key"));
        for rendered in formats.render(format, &paper::paper()).unwrap().into_iter().chain(key) {
            let path = folder().join(&rendered.name);
            if accept {
                fs::write(&path, &rendered.contents).unwrap();
            } else if fs::read_to_string(&path).unwrap_or_default() != rendered.contents {
                differing.push(rendered.name);
            }
        }
    }
    assert!(differing.is_empty(), "{differing:?} differ from tests/pages/: CAROM_ACCEPT=1 writes them anew");
}

#[test]
fn carom_knows_what_is_told_only_to_teachers() {
    let formats = Formats::shipped().unwrap();
    for (format, sheet) in
        [("latex", "question-sheet.tex"), ("html", "question-sheet.html"), ("text", "question-sheet.txt")]
    {
        let files = formats.render(format, &paper::paper()).unwrap();
        for secret in ["3.65", "55.3", "4.68", "B1", "dM1", "rest/speeds-and-directions"] {
            // a comment of LaTeX is for the teacher, who has the source
            let mut printed = file(&files, sheet).lines().filter(|line| !line.starts_with('%'));
            assert!(!printed.any(|line| line.contains(secret)), "{sheet} gives {secret} away");
        }
        for promised in ["(Total for Question 1 is 11 marks)", "(Total for Question 3 is 2 marks)", "20270312"] {
            assert!(file(&files, sheet).contains(promised), "{sheet} lacks {promised}");
        }
    }
}

#[test]
fn carom_knows_that_a_title_may_contain_anything() {
    let hostile = r"}\input{/etc/passwd} <script>alert(1)</script> $&#_^~%\ ]]> -->";
    let paper = Paper { title: hostile.into(), school: hostile.into(), date: hostile.into(), ..paper::paper() };
    let formats = Formats::shipped().unwrap();
    for rendered in formats.render("latex", &paper).unwrap() {
        assert!(!rendered.contents.contains(r"\input{"), "{}", rendered.name);
        assert!(rendered.contents.contains(r"\}\textbackslash{}input\{/etc/passwd\}"), "{}", rendered.name);
        assert!(rendered.contents.contains(r"$\$$\&\#\_{\normalfont\ttfamily\symbol{94}}$\sim$\%\textbackslash{}"));
    }
    for rendered in formats.render("html", &paper).unwrap() {
        assert!(!rendered.contents.contains("<script"), "{}", rendered.name);
        assert!(rendered.contents.contains("&lt;script&gt;alert(1)"), "{}", rendered.name);
    }
}

#[test]
fn carom_knows_that_html_fetches_nothing() {
    for rendered in Formats::shipped().unwrap().render("html", &paper::paper()).unwrap() {
        for fetched in ["<link", "<script", "@import", "url(", " src=", "@font-face"] {
            assert!(!rendered.contents.contains(fetched), "{} has {fetched}", rendered.name);
        }
    }
}

#[test]
fn a_seed_is_printed_where_the_code_alone_does_not_make_the_paper_again() {
    let formats = Formats::shipped().unwrap();
    for format in ["latex", "html", "text"] {
        for (seed, said) in [(None, false), (Some(0), true)] {
            for rendered in formats.render(format, &Paper { seed, ..paper::paper() }).unwrap() {
                assert!(rendered.contents.contains("KV7-3QX"), "{}", rendered.name);
                assert_eq!(rendered.contents.contains("Seed 0"), said, "{}", rendered.name);
            }
        }
    }
}

/// The same paper for two students.
fn class() -> [Paper; 2] {
    [("Ada Lovelace", "4J2K-8"), ("Ben & Co", "7QWM-2")].map(|(student, code)| Paper {
        student: student.into(),
        code: code.into(),
        seed: None,
        ..paper::paper()
    })
}

#[test]
fn a_class_has_the_pages_of_each_student_one_after_another() {
    let formats = Formats::shipped().unwrap();
    for (format, latin) in [("latex", r"Ben \& Co"), ("html", "Ben &amp; Co"), ("text", "Ben & Co")] {
        let files = formats.class(format, &class()).unwrap().unwrap();
        assert_eq!(files.len(), 4);
        for rendered in files {
            let text = &rendered.contents;
            let places = ["Ada Lovelace", "4J2K-8", latin, "7QWM-2"].map(|words| text.rfind(words));
            assert!(places.iter().all(Option::is_some) && places[0] < places[2], "{}: {places:?}", rendered.name);
            let mut ids: Vec<&str> = text.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
            let all = ids.len();
            ids.sort_unstable();
            ids.dedup();
            assert_eq!(ids.len(), all, "{}", rendered.name);
            assert!(format != "html" || text.matches("<main>").count() == 1, "{}", rendered.name);
        }
    }
}

#[test]
fn carom_knows_that_a_teachers_file_takes_the_place_of_one_file() {
    let formats = Formats::with([own("latex/question-sheet.tex", "<<title>>, <<marks>> marks\n")]).unwrap();
    let files = formats.render("latex", &paper::paper()).unwrap();
    assert_eq!(file(&files, "question-sheet.tex"), "Oblique impact of smooth spheres, 20 marks\n");
    let shipped = Formats::shipped().unwrap().render("latex", &paper::paper()).unwrap();
    assert_eq!(file(&files, "mark-scheme.tex"), file(&shipped, "mark-scheme.tex"));
}

#[test]
fn carom_knows_that_a_format_is_one_folder() {
    let manifest = r#"
        about = "the answers for a terminal"
        notation = "unicode"
        documents = [{ file = "answers.txt", template = "answers.txt" }]
    "#;
    let template = "{% for question in questions %}{% for part in question.parts %}\
        {% for answer in part.answers %}{% include 'one.txt' %}\n{% endfor %}{% endfor %}{% endfor %}";
    let one = "{{ question.number }}{{ part.label }} {{ answer.name }}";
    let formats = Formats::with([
        own("plain/format.toml", manifest),
        own("plain/answers.txt", template),
        own("plain/one.txt", one),
    ]);
    let formats = formats.unwrap();
    let files = formats.render("plain", &paper::paper()).unwrap();
    assert!(
        file(&files, "answers.txt").starts_with("1 speed of A\n1 direction of A\n1 speed of B\n2a velocity of A\n")
    );
    assert_eq!(formats.list().map(|(name, _)| name).collect::<Vec<_>>(), ["html", "latex", "plain", "text"]);
}

#[test]
fn carom_knows_every_folder_of_its_templates() {
    let templates = Path::new(env!("CARGO_MANIFEST_DIR")).join("templates");
    let folders = fs::read_dir(templates).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    let mut on_disk: Vec<String> =
        folders.map(|path| path.file_name().unwrap().to_string_lossy().into_owned()).collect();
    on_disk.sort();
    let mut listed: Vec<String> = Formats::shipped().unwrap().list().map(|(name, _)| name.to_string()).collect();
    listed.sort();
    assert_eq!(listed, on_disk);
}
