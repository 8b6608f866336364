//! `--format pdf` with whatever the machine has: engines that are a few lines of shell, and, where `.ci/run` has installed them, the real ones.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A machine with a folder for programs, one for work that must be empty afterwards, and nothing else.
struct Machine {
    folder: PathBuf,
    path: String,
    settings: Vec<(&'static str, String)>,
}

impl Machine {
    fn new(name: &str) -> Machine {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("pdf-{name}"));
        let _ = fs::remove_dir_all(&folder);
        for inner in ["programs", "work in progress"] {
            fs::create_dir_all(folder.join(inner)).unwrap();
        }
        let path = folder.join("programs").display().to_string();
        Machine { folder, path, settings: Vec::new() }
    }

    /// With a program that runs these lines; `$job` and `$pdf` are what it is to print.
    fn with(self, program: &str, script: &str) -> Machine {
        let path = self.folder.join("programs").join(program);
        let lines = "for a in \"$@\"; do case $a in\n\
                     -jobname=*) job=${a#*=} pdf=$job.pdf ;;\n\
                     --print-to-pdf=*) pdf=${a#*=} job=browser ;;\n\
                     esac; done";
        fs::write(&path, format!("#!/bin/sh\n{lines}\n{script}\n")).unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).unwrap();
        self
    }

    fn set(mut self, name: &'static str, value: &str) -> Machine {
        self.settings.push((name, value.to_owned()));
        self
    }

    /// What a person sees who makes a sheet in the folder `out`. Whatever comes of it, the folder for work is empty.
    fn sheet(&self, arguments: &[&str]) -> Output {
        let mut carom = Command::new(env!("CARGO_BIN_EXE_carom"));
        carom.current_dir(&self.folder).env("PATH", &self.path).env("TMPDIR", self.folder.join("work in progress"));
        for name in ["CAROM_TEX", "CAROM_BROWSER", "CAROM_PDF_SECONDS", "SOURCE_DATE_EPOCH"] {
            carom.env_remove(name);
        }
        carom.envs(self.settings.iter().map(|(name, value)| (name, value)));
        carom.args(["sheet", "--count", "1", "--seed", "3", "--out", "out"]).args(arguments);
        let output = carom.output().unwrap();
        let left: Vec<_> = fs::read_dir(self.folder.join("work in progress")).unwrap().collect();
        assert!(left.is_empty(), "{left:?}");
        output
    }

    /// The files in the folder `out`, in order.
    fn files(&self) -> Vec<String> {
        let Ok(entries) = fs::read_dir(self.folder.join("out")) else { return Vec::new() };
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    fn written(&self, ending: &str) -> usize {
        self.files().iter().filter(|name| name.ends_with(ending)).count()
    }

    fn read(&self, path: &str) -> Vec<u8> {
        fs::read(self.folder.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
    }
}

const PRINTS: &str = r#"printf '%%PDF-1.5\n%s by %s\n%%%%EOF\n' "$job" "${0##*/}" > "$pdf""#;

fn code(output: &Output) -> i32 {
    output.status.code().expect("no signal")
}

fn said(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// What is said from the first error on.
fn fault(output: &Output) -> String {
    let said = said(output);
    said[said.find("error: ").unwrap_or_else(|| panic!("no error in: {said}"))..].to_owned()
}

#[test]
fn carom_takes_the_best_that_a_machine_has_and_says_what() {
    type Case<'a> = (&'a [&'a str], &'a [(&'static str, &'a str)], &'a str);
    let cases: [Case; 10] = [
        (&["xelatex", "lualatex", "pdflatex", "chromium"], &[], "pdflatex"),
        (&["xelatex", "lualatex", "chromium"], &[], "lualatex"),
        (&["xelatex", "chromium"], &[], "xelatex"),
        (&["chromium", "google-chrome", "microsoft-edge"], &[], "google-chrome"),
        (&["chromium", "microsoft-edge"], &[], "microsoft-edge"),
        (&["chromium-browser"], &[], "chromium-browser"),
        (&["pdflatex", "lualatex"], &[("CAROM_TEX", "lualatex")], "lualatex"),
        (&["pdflatex", "chromium"], &[("CAROM_TEX", "none")], "chromium"),
        (&["chromium", "mychrome"], &[("CAROM_BROWSER", "programs/mychrome")], "mychrome"),
        (&["pdflatex", "chromium"], &[("CAROM_TEX", "")], "pdflatex"),
    ];
    for (number, (programs, settings, expected)) in cases.into_iter().enumerate() {
        let mut machine = Machine::new(&format!("choice-{number}"));
        for program in programs {
            machine = machine.with(program, PRINTS);
        }
        for (name, value) in settings {
            machine = machine.set(name, value);
        }
        let output = machine.sheet(&["--format", "pdf"]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        assert!(said(&output).contains(&format!("PDF by `{expected}`")), "{}", said(&output));
        // Nothing is written but what was asked for: a PDF for each document, and the key.
        assert!(machine.written(".pdf") >= 2 && machine.written(".pdf") + 2 == machine.files().len());
        let pdf = String::from_utf8(machine.read("out/question-sheet.pdf")).unwrap();
        assert!(pdf.ends_with(&format!("by {expected}\n%%EOF\n")), "{pdf}");
    }
}

#[test]
fn letters_that_tex_lacks_are_left_to_a_browser_and_where_there_is_none_to_the_person() {
    const SAID: &str = "warning: `Владимир` has letters that LaTeX's own fonts lack: in the PDF each is a `?`";
    type Case<'a> = (&'a [(&'a str, &'a str)], &'a [(&'static str, &'a str)], &'a str, bool);
    let cases: [Case; 5] = [
        (&[("pdflatex", PRINTS), ("chromium", PRINTS)], &[], "chromium", false),
        (&[("pdflatex", PRINTS)], &[], "pdflatex", true),
        (&[("pdflatex", PRINTS), ("chromium", PRINTS)], &[("CAROM_TEX", "pdflatex")], "pdflatex", true),
        (&[("pdflatex", PRINTS), ("chromium", PRINTS)], &[("CAROM_BROWSER", "none")], "pdflatex", true),
        (&[("pdflatex", PRINTS), ("chromium", "exit 1")], &[], "pdflatex", true),
    ];
    for (number, (programs, settings, expected, is_warned)) in cases.into_iter().enumerate() {
        let mut machine = Machine::new(&format!("letters-{number}"));
        for (program, script) in programs {
            machine = machine.with(program, script);
        }
        for (name, value) in settings {
            machine = machine.set(name, value);
        }
        let output = machine.sheet(&["--format", "pdf", "--school", "Владимир"]);
        assert_eq!(code(&output), 0, "{}", said(&output));
        let pdf = String::from_utf8(machine.read("out/question-sheet.pdf")).unwrap();
        assert!(pdf.ends_with(&format!("by {expected}\n%%EOF\n")), "{number}: {pdf}");
        assert_eq!(said(&output).contains(SAID), is_warned, "{number}: {}", said(&output));
        assert_eq!(said(&output).contains("look whether they are all there"), !is_warned, "{number}");
        // Names that TeX has are no reason for anything.
        let plain = machine.sheet(&["--format", "pdf", "--school", "Łukasz Müller"]);
        let told = said(&plain);
        assert!(told.contains("latex") && !told.contains("warning"), "{number}: {told}");
    }
}

#[test]
fn latex_says_which_names_it_prints_as_question_marks() {
    let machine = Machine::new("question-marks");
    fs::write(machine.folder.join("class.csv"), "student,name\n1,Владимир\n2,Zoë\n3,李小龍\n").unwrap();
    let told = said(&machine.sheet(&["--format", "latex,html", "--class", "class.csv"]));
    let said_once =
        "warning: `Владимир (1)`, `李小龍 (3)` have letters that LaTeX's own fonts lack: in the LaTeX each is a `?`";
    assert!(told.contains(said_once) && told.matches("warning").count() == 1, "{told}");
    let told = said(&machine.sheet(&["--format", "html", "--class", "class.csv"]));
    assert!(!told.contains("warning"), "{told}");
}

#[test]
fn a_browser_that_falls_over_in_starting_is_asked_once_more() {
    // What it leaves of itself outside its profile.
    let socket = r#"
        for a in "$@"; do case $a in --user-data-dir=*) profile=${a#*=} ;; esac; done
        left="$TMPDIR/org.chromium.Chromium.$$"
        /bin/mkdir -p "$profile" "$left"
        : > "$left/SingletonSocket"
        /bin/ln -s "$left/SingletonSocket" "$profile/SingletonSocket""#;
    let falls = format!("[ -e fallen ] || {{ {socket}\n: > fallen; kill -s SEGV $$; }}");
    let machine = Machine::new("falls").with("chromium", &format!("{falls}\n{PRINTS}"));
    let output = machine.sheet(&["--format", "pdf"]);
    assert_eq!(code(&output), 0, "{}", said(&output));
    assert!(machine.written(".pdf") >= 2, "{:?}", machine.files());
}

#[test]
fn carom_prints_each_latex_document_beside_the_formats_asked_for() {
    let machine = Machine::new("beside").with("pdflatex", PRINTS);
    assert_eq!(code(&machine.sheet(&["--format", "latex,html,pdf,html,pdf"])), 0);
    for document in machine.files().iter().filter_map(|name| name.strip_suffix(".tex")) {
        let pdf = String::from_utf8(machine.read(&format!("out/{document}.pdf"))).unwrap();
        assert!(pdf.contains(&format!("\n{document} by pdflatex\n")), "{pdf}");
    }
    assert_eq!(
        (machine.written(".pdf"), machine.written(".tex")),
        (machine.written(".html"), machine.written(".html"))
    );
}

#[test]
fn carom_says_what_to_install_where_there_is_nothing_and_keeps_the_rest() {
    let machine = Machine::new("nothing").set("CAROM_TEX", "none").set("CAROM_BROWSER", "none");
    let output = machine.sheet(&["--format", "latex,pdf"]);
    assert_eq!(code(&output), 1);
    let told = fault(&output);
    assert!(told.starts_with("error: nothing on this machine can make a PDF\nhelp: install "), "{told}");
    assert_eq!((machine.written(".html"), machine.written(".pdf")), (0, 0));
    assert!(machine.written(".tex") >= 2 && machine.files().contains(&"key.json".to_owned()));
    assert_eq!(String::from_utf8(output.stdout.clone()).unwrap().lines().count(), machine.files().len());
}

#[test]
fn carom_writes_html_to_print_by_hand_where_pdf_alone_was_asked_for() {
    let machine = Machine::new("by-hand").set("CAROM_TEX", "none").set("CAROM_BROWSER", "none");
    let output = machine.sheet(&["--format", "pdf"]);
    assert_eq!((code(&output), machine.written(".pdf")), (1, 0));
    assert!(machine.written(".html") >= 2);
    assert!(said(&output).contains("open it in any browser and print it from there"), "{}", said(&output));
}

#[test]
fn a_program_is_not_taken_from_the_folder_where_one_stands() {
    let mut machine = Machine::new("here").with("pdflatex", PRINTS).set("CAROM_BROWSER", "none");
    fs::copy(machine.folder.join("programs/pdflatex"), machine.folder.join("pdflatex")).unwrap();
    machine.path = "::programs:.".to_owned();
    let output = machine.sheet(&["--format", "html,pdf"]);
    assert_eq!(code(&output), 1);
    assert!(said(&output).contains("nothing on this machine"), "{}", said(&output));
}

#[test]
fn a_tex_engine_is_shut_in_and_told_where_it_is() {
    let record = r#"echo "$openin_any $openout_any $TEXMFOUTPUT $(pwd) $*" >> "$RECORD""#;
    let machine = Machine::new("shut-in").with("pdflatex", &format!("{record}\necho x > $job.aux\n{PRINTS}"));
    let file = machine.folder.join("record").display().to_string();
    let machine = machine.set("RECORD", &file);
    assert_eq!(code(&machine.sheet(&["--format", "pdf"])), 0);
    let record = String::from_utf8(machine.read("record")).unwrap();
    // Each document twice: what it remembers is the same after the second time.
    assert_eq!(record.lines().count(), 2 * machine.written(".pdf"), "{record}");
    for line in record.lines() {
        assert!(line.starts_with("p p /") && line.contains("/work in progress/carom-"), "{line}");
        for option in ["-interaction=nonstopmode", "-halt-on-error", "-file-line-error", "-no-shell-escape"] {
            assert!(line.contains(option), "{line} lacks {option}");
        }
    }
}

#[test]
fn a_document_is_set_again_until_it_remembers_the_same_but_not_for_ever() {
    let machine =
        Machine::new("again").with("pdflatex", &format!("echo x >> $job.aux\necho x >> \"$RECORD\"\n{PRINTS}"));
    let file = machine.folder.join("record").display().to_string();
    let machine = machine.set("RECORD", &file);
    assert_eq!(code(&machine.sheet(&["--format", "pdf"])), 0);
    assert_eq!(machine.read("record").len(), "x\n".len() * 4 * machine.written(".pdf"));
}

/// Two documents that are one line each, so that what is said about them can be written down here.
fn of_two_lines(machine: Machine) -> Machine {
    let folder = machine.folder.join("mine/latex");
    fs::create_dir_all(&folder).unwrap();
    let manifest = "about = 'short'\nnotation = 'latex'\ndocuments = [{ file = 'sheet.tex', template = 'sheet.tex' }]\n\
                    [delimiters]\nvariable = ['<<', '>>']\nblock = ['<%', '%>']\ncomment = ['<#', '#>']\n";
    fs::write(folder.join("format.toml"), manifest).unwrap();
    let sheet =
        "\\documentclass{article}\n\\usepackage{tikz}\n\\begin{document}\n\\headed{<<title>>}\n\\end{document}\n";
    fs::write(folder.join("sheet.tex"), sheet).unwrap();
    machine
}

#[test]
fn an_error_of_tex_is_told_by_line_and_template_and_not_as_a_log() {
    let cases = [
        (
            "./sheet.tex:4: Undefined control sequence.\nl.4 \\headed\n           {Oblique}",
            "error: unknown command `\\headed`\n --> out/sheet.tex:4:1\n  |\n\
             4 | \\headed{Oblique impacts of smooth spheres}\n  | ^^^^^^^ no such command\n  |\n\
             help: mend the line where it comes from: `mine/latex/sheet.tex`, line 4\n",
        ),
        (
            "! LaTeX Error: File `tikz.sty' not found.\n\nType X to quit\n\n./sheet.tex:3: Emergency stop.\nl.3 \\begin",
            "error: the LaTeX package `tikz` is not installed\n --> out/sheet.tex:2:13\n  |\n\
             2 | \\usepackage{tikz}\n  |             ^^^^ needed here\n  |\nhelp: install it",
        ),
        (
            "/usr/share/pgf/tikz.sty:99: Package tikz Error: I am lost.\n\nl.99 \\fi\n        %",
            "error: package `tikz`: I am lost\n --> out/sheet.tex:2:13\n",
        ),
        (
            "! I can't find the format file `pdflatex.fmt'!",
            "error: `pdflatex` is not fully installed: its format file is missing\nhelp: install LaTeX",
        ),
        ("What a day.", "error: `pdflatex` failed on `sheet.tex` without saying why\nhelp: "),
    ];
    for (number, (log, expected)) in cases.into_iter().enumerate() {
        let script = format!("/bin/cat <<'END'\nThis is pdfTeX (./sheet.tex)\n{log}\nEND\nexit 1");
        let machine =
            of_two_lines(Machine::new(&format!("log-{number}")).with("pdflatex", &script)).with("chromium", PRINTS);
        let title = "Oblique impacts of smooth spheres";
        let output = machine.sheet(&["--format", "html,pdf", "--templates", "mine", "--title", title]);
        assert_eq!(code(&output), 1);
        let told = fault(&output);
        assert!(told.starts_with(expected), "{told}\nis not\n{expected}");
        assert!(told.lines().count() <= 8, "a log: {told}");
        // The browser is not tried in silence, and what else was asked for is there.
        assert_eq!((machine.written(".pdf"), machine.written(".tex")), (0, 0));
        assert!(machine.written(".html") >= 2);
    }
}

#[test]
fn the_latex_that_fails_is_left_to_be_looked_at_where_pdf_alone_was_asked_for() {
    let machine = of_two_lines(Machine::new("left").with("pdflatex", "echo './sheet.tex:4: No.'; exit 1"));
    let output = machine.sheet(&["--format", "pdf", "--templates", "mine"]);
    assert_eq!(
        (code(&output), machine.files()),
        (1, ["key.json", "sheet.tex", "submissions.csv"].map(str::to_owned).to_vec())
    );
    assert!(fault(&output).contains("--> out/sheet.tex:4:"), "{}", said(&output));
}

#[test]
fn what_is_no_pdf_is_not_written() {
    let cases = [
        ("nothing", "pdflatex", "exit 0"),
        ("half", "pdflatex", "printf '%%PDF-1.5 and no end' > $pdf"),
        ("other", "pdflatex", "echo words > $pdf"),
        ("link", "pdflatex", "/bin/ln -sf \"$SECRET\" $pdf"),
        ("page", "chromium", "exit 0"),
        ("half-page", "chromium", "printf '%%PDF-1.5 and no end' > \"$pdf\""),
    ];
    for (name, program, script) in cases {
        let machine = Machine::new(&format!("no-pdf-{name}")).with(program, script);
        let secret = machine.folder.join("secret.pdf");
        fs::write(&secret, "%PDF-1.5\nmarks\n%%EOF\n").unwrap();
        symlink(&secret, machine.folder.join("link")).unwrap();
        let machine = machine.set("SECRET", &secret.display().to_string());
        let output = machine.sheet(&["--format", "html,pdf"]);
        assert_eq!((code(&output), machine.written(".pdf")), (1, 0), "{name}: {}", said(&output));
        assert!(machine.written(".html") >= 2);
        let told = fault(&output);
        assert!(
            told.starts_with(&format!("error: `{program}` made no PDF of `")) && told.contains("\nhelp: "),
            "{told}"
        );
    }
}

#[test]
fn an_engine_that_hangs_or_rambles_is_stopped() {
    let slow = Machine::new("hangs").with("pdflatex", "/bin/sleep 1000").set("CAROM_PDF_SECONDS", "1");
    let output = slow.sheet(&["--format", "html,pdf"]);
    assert_eq!((code(&output), slow.written(".pdf")), (1, 0));
    let told = fault(&output);
    assert!(
        told.contains("`pdflatex` was stopped: it was still at work on `") && told.contains("` after 1 s\n"),
        "{told}"
    );
    assert!(told.contains("CAROM_PDF_SECONDS=600"), "{told}");

    let loud = Machine::new("rambles").with("chromium", "while :; do echo words words words words words words; done");
    let told = fault(&loud.sheet(&["--format", "html,pdf"]));
    assert!(told.contains("would not stop printing messages"), "{told}");
}

#[test]
fn a_setting_that_means_nothing_is_told() {
    for (name, value, expected) in [
        ("CAROM_TEX", "pdfltx", "error: `CAROM_TEX` names `pdfltx`, which is no program here\nhelp: "),
        ("CAROM_BROWSER", "/nowhere/chrome", "error: `CAROM_BROWSER` names `/nowhere/chrome`, which is no program"),
        ("CAROM_PDF_SECONDS", "soon", "error: `CAROM_PDF_SECONDS` is `soon`, which is no number of seconds\nhelp: "),
        ("CAROM_PDF_SECONDS", "0", "error: `CAROM_PDF_SECONDS` is `0`"),
    ] {
        let mut machine = Machine::new("setting").with("chromium", PRINTS);
        machine = machine.set(name, value);
        let output = machine.sheet(&["--format", "html,pdf"]);
        assert_eq!((code(&output), machine.written(".pdf")), (1, 0));
        assert!(fault(&output).starts_with(expected), "{}", said(&output));
    }
}

#[test]
fn pdf_is_among_the_formats_and_is_no_folder_of_templates() {
    let machine = Machine::new("names");
    let output = machine.sheet(&["--format", "docx"]);
    assert!(said(&output).contains("unknown format `docx`\nhelp: there are `html`, `latex`"), "{}", said(&output));
    assert!(said(&output).contains("`pdf`"), "{}", said(&output));
    assert!(machine.files().is_empty());
    fs::create_dir_all(machine.folder.join("mine/pdf")).unwrap();
    let manifest = "about = 'x'\nnotation = 'html'\ndocuments = [{ file = 'x.txt', template = 'x.txt' }]\n";
    fs::write(machine.folder.join("mine/pdf/format.toml"), manifest).unwrap();
    fs::write(machine.folder.join("mine/pdf/x.txt"), "x").unwrap();
    let output = machine.sheet(&["--templates", "mine"]);
    assert!(fault(&output).contains("a format of your own is called `pdf`"), "{}", said(&output));
    assert!(machine.files().is_empty());
}

#[test]
fn a_pdf_of_an_earlier_sheet_is_told_where_there_is_no_new_one() {
    let machine = Machine::new("earlier").with("pdflatex", PRINTS).set("CAROM_BROWSER", "none");
    machine.sheet(&["--format", "pdf"]);
    let machine = machine.set("CAROM_TEX", "none");
    let output = machine.sheet(&["--format", "latex,pdf"]);
    let words = "`out/mark-scheme.pdf`, `out/question-sheet.pdf`, `out/worked-solutions.pdf` are of an earlier sheet";
    assert!(said(&output).contains(words), "{}", said(&output));
}

mod real {
    use super::*;

    /// A machine with all the programs of this one.
    fn machine(name: &str) -> Machine {
        let mut machine = Machine::new(name);
        machine.path = std::env::var("PATH").unwrap();
        machine
    }

    fn pages_and_words(pdf: &Path) -> (usize, String) {
        let output = Command::new("pdftotext").arg(pdf).arg("-").output().expect("pdftotext");
        assert!(output.status.success(), "{}", pdf.display());
        let text = String::from_utf8(output.stdout).unwrap();
        // A page ends with a form feed.
        (text.matches('\u{c}').count(), text.split_whitespace().collect::<Vec<_>>().join(" "))
    }

    /// The sheets that an engine prints: numbered pages, words that can be searched, and the same bytes every time.
    fn prints(name: &str, settings: [(&'static str, &str); 1]) {
        let mut machine = machine(name);
        machine.settings = settings.map(|(name, value)| (name, value.to_owned())).to_vec();
        let arguments = ["--format", "html,pdf", "--title", "Oblique & other impacts"];
        let output = machine.sheet(&arguments);
        assert_eq!(code(&output), 0, "{}", said(&output));
        let documents: Vec<String> = machine.files().into_iter().filter(|name| name.ends_with(".pdf")).collect();
        assert_eq!(documents.len(), machine.written(".html"));
        let first: Vec<Vec<u8>> = documents.iter().map(|name| machine.read(&format!("out/{name}"))).collect();
        for name in &documents {
            let (pages, words) = pages_and_words(&machine.folder.join("out").join(name));
            assert!(words.contains("Oblique & other impacts"), "{name}: {words}");
            assert!(words.contains(&format!("{pages} of {pages}")), "{name} has {pages} pages: {words}");
            assert!(
                !words.contains(&format!("{pages} of {}", pages + 1)) && !words.contains("file://"),
                "{name}: {words}"
            );
        }
        assert_eq!(code(&machine.sheet(&arguments)), 0);
        for (name, first) in documents.iter().zip(first) {
            assert!(machine.read(&format!("out/{name}")) == first, "{name} is another file the second time");
        }
    }

    #[test]
    #[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
    fn pdflatex_prints_a_sheet() {
        prints("pdflatex", [("CAROM_TEX", "pdflatex")]);
    }

    #[test]
    #[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
    fn lualatex_and_xelatex_print_a_sheet_where_they_are() {
        for engine in ["lualatex", "xelatex"] {
            if Command::new(engine).arg("--version").output().is_ok() {
                prints(engine, [("CAROM_TEX", engine)]);
            }
        }
    }

    #[test]
    #[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
    fn a_browser_prints_a_sheet() {
        prints("browser", [("CAROM_TEX", "none")]);
    }

    /// A format of one document with a line in it, and what pdflatex has against that.
    fn told(name: &str, preamble: &str, line: &str) -> (Machine, String) {
        let machine = of_two_lines(machine(name)).set("CAROM_TEX", "pdflatex");
        let sheet = format!("\\documentclass{{article}}\n{preamble}\n\\begin{{document}}\n{line}\n\\end{{document}}\n");
        fs::write(machine.folder.join("mine/latex/sheet.tex"), sheet).unwrap();
        let output = machine.sheet(&["--format", "pdf", "--templates", "mine"]);
        assert_eq!((code(&output), machine.written(".pdf")), (1, 0), "{}", said(&output));
        let told = fault(&output);
        (machine, told)
    }

    #[test]
    #[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
    fn pdflatex_is_understood() {
        let cases = [
            ("", r"Find \vectr{v}.", "unknown command `\\vectr`", "4:6", "`mine/latex/sheet.tex`, line 4"),
            (r"\newcommand{\vv}{\wrong}", r"Find \vv.", "unknown command `\\wrong`", "4:6", "line 4"),
            ("", r"\begin{foo}", "unknown environment `foo`", "4:8", "line 4"),
            (r"\usepackage{siunitxx}", "x", "the LaTeX package `siunitxx` is not installed", "2:13", "install it"),
            ("", "a x^2 b", "missing $ inserted", "4:4", "line 4"),
            ("", r"\input{/etc/hostname}", "`/etc/hostname` may not be read", "4:8", "line 4"),
            ("", "中", "`pdflatex` has no letter 中 (U+4E2D)", "4:1", "CAROM_TEX=none"),
            (r"\usepackage[klingon]{babel}", "x", "package `babel`: ", "2:22", "line 2"),
        ];
        for (number, (preamble, line, message, place, help)) in cases.into_iter().enumerate() {
            let (_, told) = told(&format!("real-{number}"), preamble, line);
            assert!(told.starts_with(&format!("error: {message}")), "{told}");
            assert!(told.contains(&format!("--> out/sheet.tex:{place}")), "{told}");
            assert!(told.split("\nhelp: ").nth(1).is_some_and(|said| said.contains(help)), "{told}");
        }
    }

    #[test]
    #[ignore = "needs TeX, poppler and Chromium, which `.ci/run` installs"]
    fn pdflatex_writes_no_file_but_its_own() {
        for path in ["../outside.txt", "/tmp/carom-outside.txt"] {
            let (machine, told) = told("outside", "", &format!("\\newwrite\\w\\immediate\\openout\\w={path} x"));
            assert!(told.starts_with(&format!("error: `{path}` may not be written")), "{told}");
            assert!(!machine.folder.join("work in progress").join(path).exists());
        }
    }
}
