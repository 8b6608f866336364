//! `carom preview` as an author meets it: in the terminal, in a browser, and while she edits.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Output, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Carom in a pipe of a known width, with no browser of this machine.
fn carom(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    command.args(arguments).env("COLUMNS", "80").env_remove("BROWSER");
    command
}

fn preview(arguments: &[&str]) -> Output {
    carom(&[&["preview"], arguments].concat()).output().unwrap()
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A bank of one question in a folder of this test's own, and the path of the question.
fn bank(name: &str) -> (PathBuf, String) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("preview-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(folder.join("rest")).unwrap();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("question_bank/rest/speeds-and-directions.toml");
    let path = folder.join("rest/speeds-and-directions.toml");
    fs::copy(shipped, &path).unwrap();
    (folder, path.display().to_string())
}

fn edit(path: &str, from: &str, to: &str) {
    let text = fs::read_to_string(path).unwrap();
    assert!(text.contains(from), "{path} has no {from}");
    fs::write(path, text.replacen(from, to, 1)).unwrap();
}

#[test]
fn an_author_sees_question_solution_marks_and_answers() {
    let output = preview(&["5C-2", "--reference"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = stdout(&output);
    for expected in [
        "rest/speeds-and-directions, after 5C-2 ",
        "Worked solution",
        "Mark scheme",
        "4√39/9 ≈ 2.78 m s⁻¹",
        "46.1° to the line of centres",
    ] {
        assert!(text.contains(expected), "{expected} is not in\n{text}");
    }
    assert!(text.lines().all(|line| line.chars().count() <= 80), "{text}");
    assert!(!text.contains(['\u{1b}', '\u{a0}', '¦', '¶']), "{text}");
    assert!(stderr(&output).contains("the numbers of the exercise"), "{}", stderr(&output));
}

#[test]
fn what_check_calls_an_error_is_said_beside_the_page() {
    let (folder, path) = bank("amiss");
    edit(&path, "{mA kg}", "{mB kg}");
    let output = preview(&[&path, "--seed", "1"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(stdout(&output).contains("Mark scheme"), "{}", stdout(&output));
    let said = stderr(&output);
    assert!(said.starts_with("error: `rest/speeds-and-directions`: the words"), "{said}");
    assert!(said.contains(&format!("`carom check {}` says where", folder.display())), "{said}");
    edit(&path, "{mB kg}", "{mA kg}");
    assert!(!stderr(&preview(&[&path, "--seed", "1"])).contains("error"));
}

#[test]
fn fresh_numbers_come_again_by_their_seed_from_bank_and_from_file() {
    let first = preview(&["rest/speeds-and-directions"]);
    let said = stderr(&first);
    let seed = said.split("--seed ").nth(1).unwrap().split('`').next().unwrap();
    let (folder, path) = bank("seed");
    let bank = folder.to_str().unwrap();
    for again in [&["5C-2", "--seed", seed][..], &[&path, "--seed", seed], &["5C-2", "--bank", bank, "--seed", seed]] {
        assert_eq!(stdout(&preview(again)), stdout(&first), "{again:?}");
    }
    let styled = preview(&["5C-2", "--seed", seed, "--style", "friendly"]);
    assert!(
        stderr(&styled).contains(&format!("style friendly; `--seed {seed} --style friendly`")),
        "{}",
        stderr(&styled)
    );
}

#[test]
fn every_question_keeps_to_the_width() {
    let bank = carom::bank::Contents::shipped();
    for (width, heading) in [60, 80].into_iter().flat_map(|width| bank.headings.iter().map(move |it| (width, it))) {
        let output =
            carom(&["preview", &heading.id, "--seed", "5"]).env("COLUMNS", width.to_string()).output().unwrap();
        for line in stdout(&output).lines() {
            assert!(line.chars().count() <= width, "{} in {width}:\n{line}", heading.id);
        }
    }
}

#[test]
fn what_is_wrong_is_said_and_nothing_shown() {
    let (_, path) = bank("wrong");
    edit(&path, "title", "titel");
    let (_, other) = bank("style");
    edit(&other, "[style.friendly]\n", "[style.exact]\n");
    let cases: [(&[&str], &[&str]); 6] = [
        (&[&path], &["error: ", "titel", "speeds-and-directions.toml:", "^^^^^"]),
        (&["no/such.toml"], &["`no/such.toml` cannot be read"]),
        (&["5C-22"], &["unknown question `5C-22`", "did you mean"]),
        (&["5C-2", "--templates", "no-such"], &["the templates in `no-such` cannot be read"]),
        (&["5C-2", "--watch"], &["no file to watch", "copy"]),
        (&[&other], &["error: "]),
    ];
    for (arguments, expected) in cases {
        let output = preview(arguments);
        assert_eq!((output.status.code(), stdout(&output).as_str()), (Some(1), ""), "{arguments:?}");
        for words in expected {
            assert!(stderr(&output).contains(words), "{arguments:?}: {words} is not in\n{}", stderr(&output));
        }
    }
}

#[test]
fn templates_of_ones_own_change_the_preview() {
    let (folder, path) = bank("templates");
    let text = folder.join("templates/text");
    fs::create_dir_all(&text).unwrap();
    fs::write(text.join("preview.txt"), "{% for question in questions %}{{ question.marks }} in all{% endfor %}")
        .unwrap();
    let templates = folder.join("templates").display().to_string();
    let output = preview(&[&path, "--templates", &templates, "--reference"]);
    assert_eq!(stdout(&output), "11 in all\n", "{}", stderr(&output));
}

#[test]
fn a_template_that_nothing_uses_is_told_of() {
    let (folder, path) = bank("unused");
    let templates = folder.join("templates").display().to_string();
    fs::create_dir_all(folder.join("templates/text")).unwrap();
    fs::write(folder.join("templates/text/previw.txt"), "mine").unwrap();
    let arguments = [&path, "--templates", &templates, "--reference"];
    let expected = ["warning: nothing uses `text/previw.txt`", "did you mean `preview.txt`?"];
    let output = preview(&arguments);
    assert!(output.status.success() && stdout(&output).contains("Worked solution"), "{}", stderr(&output));
    let watching = Watching::start(&arguments);
    for said in [stderr(&output), watching.showing()] {
        assert!(expected.iter().all(|words| said.contains(words)), "{said}");
    }
    fs::rename(folder.join("templates/text/previw.txt"), folder.join("templates/text/preview.txt")).unwrap();
    let mended = watching.showing();
    assert!(mended.contains("mine") && !mended.contains("warning: "), "{mended}");
    watching.end();
}

#[cfg(unix)]
#[test]
fn a_browser_is_given_the_page() {
    use std::os::unix::fs::PermissionsExt;
    let (folder, path) = bank("browser");
    let browser = folder.join("browser");
    fs::write(&browser, "#!/bin/sh\necho \"$1\" > \"$0.opened\"\n").unwrap();
    fs::set_permissions(&browser, fs::Permissions::from_mode(0o755)).unwrap();
    let page = folder.join("page.html").display().to_string();
    let mut command = carom(&["preview", &path, "--reference", "--open", "--out", &page]);
    let output = command.env("BROWSER", &browser).output().unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(stdout(&output), format!("{page}\n"));
    assert_eq!(fs::read_to_string(folder.join("browser.opened")).unwrap(), format!("{page}\n"));
    let html = fs::read_to_string(&page).unwrap();
    for expected in ["<math", "awrt", "Momentum is conserved"] {
        assert!(html.contains(expected), "{expected} is not in the page");
    }
    assert!(!html.contains("http-equiv=\"refresh\""), "a page that nobody changes need not reload");

    let temporary = folder.join("temporary");
    fs::create_dir(&temporary).unwrap();
    let mut command = carom(&["preview", &path, "--reference", "--open"]);
    let output = command.env("PATH", "").env("TMPDIR", &temporary).output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    let shown = stdout(&output);
    assert!(shown.starts_with(temporary.to_str().unwrap()) && Path::new(shown.trim()).is_file(), "{shown}");
    assert!(stderr(&output).contains("no browser could be started"), "{}", stderr(&output));
    let private = fs::metadata(Path::new(shown.trim()).parent().unwrap()).unwrap().permissions().mode();
    assert_eq!(private & 0o777, 0o700);
}

/// A preview that watches, until its stdin is closed.
struct Watching {
    child: Child,
    stdin: Option<ChildStdin>,
    lines: Receiver<String>,
}

/// How long a slow machine may take; a fast one waits for nothing.
const PATIENCE: Duration = Duration::from_secs(60);

impl Watching {
    fn start(arguments: &[&str]) -> Watching {
        let mut command = carom(&[&["preview", "--watch"], arguments].concat());
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().unwrap();
        let (sender, lines) = channel();
        let stdout = BufReader::new(child.stdout.take().unwrap());
        thread::spawn(move || stdout.lines().map_while(Result::ok).try_for_each(|line| sender.send(line)));
        Watching { stdin: child.stdin.take(), child, lines }
    }

    /// What is shown up to the line that ends each showing.
    fn showing(&self) -> String {
        let mut text = String::new();
        loop {
            let line = self.lines.recv_timeout(PATIENCE).unwrap_or_else(|_| panic!("nothing after\n{text}"));
            text.push_str(&line);
            text.push('\n');
            if line.starts_with("watching ") {
                return text;
            }
        }
    }

    /// Closes its stdin and waits for its end.
    fn end(mut self) {
        self.stdin = None;
        let deadline = Instant::now() + PATIENCE;
        while Instant::now() < deadline {
            if let Some(status) = self.child.try_wait().unwrap() {
                assert!(status.success(), "{status}");
                assert!(self.lines.recv_timeout(PATIENCE).is_err(), "nothing is shown at the end");
                return;
            }
            thread::sleep(Duration::from_millis(20));
        }
        panic!("it watches on");
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        // Only a failed test leaves it running.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

#[test]
fn an_author_sees_each_save_and_each_fault_in_place() {
    let (_, path) = bank("watch");
    let sound = fs::read_to_string(&path).unwrap();
    let watching = Watching::start(&[&path, "--seed", "7"]);
    let first = watching.showing();
    assert!(first.contains("A smooth uniform sphere") && first.contains(&format!("watching {path}")), "{first}");

    edit(&path, "A smooth uniform sphere", "A very smooth uniform sphere");
    let second = watching.showing();
    assert!(second.starts_with("═════"), "a line parts them: {second}");
    assert!(second.contains("A very smooth uniform sphere"), "{second}");
    let numbers = |text: &str| text.split("Worked solution").nth(1).unwrap().to_string();
    assert_eq!(numbers(&second), numbers(&first), "the same numbers, so that the author compares");

    edit(&path, "{mA kg}", "{mX kg}");
    let fault = watching.showing();
    assert!(fault.contains("error: ") && fault.contains("mX") && fault.contains('^'), "{fault}");
    assert!(!fault.contains("Worked solution"), "{fault}");

    // Saved by renaming: gone for a moment, then there again.
    fs::remove_file(&path).unwrap();
    thread::sleep(Duration::from_millis(300));
    fs::write(format!("{path}.new"), &sound).unwrap();
    fs::rename(format!("{path}.new"), &path).unwrap();
    let mended = watching.showing();
    assert!(mended.contains("Worked solution") && !mended.contains("error: "), "{mended}");
    assert_eq!(numbers(&mended), numbers(&first));

    fs::remove_file(&path).unwrap();
    let gone = watching.showing();
    assert!(gone.contains("cannot be read"), "{gone}");
    watching.end();
}

#[test]
fn a_page_that_is_watched_loads_itself_again_and_shows_faults() {
    let (folder, path) = bank("watch-page");
    let page = folder.join("page.html");
    let templates = folder.join("templates");
    fs::create_dir_all(templates.join("html")).unwrap();
    let out = ["--open", "--out", page.to_str().unwrap(), "--templates", templates.to_str().unwrap()];
    let watching = Watching::start(&[&[path.as_str(), "--reference"], &out[..]].concat());
    let shown = watching.showing();
    assert!(shown.contains(page.to_str().unwrap()), "{shown}");
    let html = || fs::read_to_string(&page).unwrap();
    assert!(html().contains("http-equiv=\"refresh\"") && html().contains("<math"));

    edit(&path, "{mA kg}", "{m<X kg}");
    assert!(watching.showing().contains("error: "));
    assert!(html().contains("http-equiv=\"refresh\"") && html().contains("m&lt;X kg") && !html().contains("<math"));

    edit(&path, "{m<X kg}", "{mA kg}");
    assert!(!watching.showing().contains("error: "));
    fs::write(templates.join("html/preview.html"), "<head>\n{{ titel }}").unwrap();
    let fault = watching.showing();
    assert!(fault.contains("unknown name `titel`") && html().contains("unknown name `titel`"), "{fault}");
    watching.end();
}
