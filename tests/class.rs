//! `carom sheet --class` as a teacher meets it: fair and different sheets, the same again next week, and lists as they come.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use carom::bank::{Contents, Question};
use carom::generate::examine;
use carom::paper::{Alike, Candidate, deal};
use serde_json::Value as Json;

fn carom(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_carom")).current_dir(folder).args(arguments).output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// An empty folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("class-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Makes the sheets of a list that is written to a file.
fn class(folder: &Path, list: impl AsRef<[u8]>, options: &[&str]) -> Output {
    fs::write(folder.join("class.csv"), list).unwrap();
    let mut arguments = vec!["sheet", "--class", "class.csv"];
    arguments.extend(options);
    carom(folder, &arguments)
}

fn made(output: Output) -> Output {
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    output
}

fn json(path: PathBuf) -> Json {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

fn papers(folder: &Path) -> Vec<Json> {
    json(folder.join("sheet/key.json"))["papers"].as_array().unwrap().clone()
}

fn numbered(count: usize) -> String {
    let rows: Vec<String> = (1..=count).map(|number| format!("{number},Student {number}\n")).collect();
    format!("student,name\n{}", rows.concat())
}

#[test]
fn each_student_has_other_numbers_and_nobody_another_kind_of_sheet() {
    let folder = folder("fair");
    made(class(&folder, numbered(30), &["--seed", "7", "--count", "3", "--format", "html"]));
    let papers = papers(&folder);
    assert_eq!(papers.len(), 30);
    let codes: BTreeSet<&str> = papers.iter().map(|paper| paper["code"].as_str().unwrap()).collect();
    assert_eq!(codes.len(), 30);
    for place in 0..3 {
        let question = |paper: &Json| paper["questions"][place].clone();
        let numbers: BTreeSet<String> = papers.iter().map(|paper| question(paper)["parameters"].to_string()).collect();
        assert_eq!(numbers.len(), 30, "question {place}");
        let kinds: BTreeSet<String> =
            papers.iter().map(|paper| format!("{} {}", question(paper)["id"], question(paper)["style"])).collect();
        assert_eq!(kinds.len(), 1, "{kinds:?}");
    }
    let sheets = fs::read_to_string(folder.join("sheet/question-sheets.html")).unwrap();
    let order: Vec<usize> = (1..=30).map(|n| sheets.find(&format!("<b>Student {n} ({n})</b>")).unwrap()).collect();
    assert!(order.is_sorted(), "in the order of the class");
    assert!(codes.iter().all(|code| sheets.contains(*code)));
}

#[test]
fn what_is_dealt_is_alike_in_motion_in_surds_and_in_e_and_about_as_long() {
    let contents = Contents::shipped();
    let question = |id: &str| -> Question {
        contents.headings.iter().find(|heading| heading.id == id).unwrap().question().unwrap_or_else(|_| panic!("{id}"))
    };
    let three =
        ["rest/components-of-each-velocity", "i-j/energy-lost", "rest/components-of-each-velocity"].map(question);
    let questions: Vec<&Question> = three.iter().collect();
    for seed in 0..2 {
        let class = deal(&questions, 12, seed, None, &[]).unwrap();
        let mut totals = vec![0; 12];
        for (place, question) in questions.iter().enumerate() {
            let candidates: Vec<Candidate> =
                class.hands.iter().map(|hand| Candidate::of(question, &hand[place]).unwrap()).collect();
            let kinds: BTreeSet<_> = candidates.iter().map(|one| (one.likeness.motion, one.likeness.surds)).collect();
            let es: BTreeSet<&str> = candidates.iter().map(|one| one.likeness.e.as_str()).collect();
            let dealt = &class.places[place];
            assert!(kinds.len() == 1 && dealt.alike != Alike::InStyle, "{kinds:?}");
            assert!(es.len() == 1 || dealt.alike != Alike::Wholly, "{es:?}");
            let figures = candidates.iter().map(|one| one.figures);
            let range = (figures.clone().min().unwrap(), figures.clone().max().unwrap());
            assert_eq!(range, dealt.figures);
            totals.iter_mut().zip(figures).for_each(|(total, figures)| *total += figures);
        }
        // The same question twice: still nothing twice.
        let of_both = class.hands.iter().flat_map(|hand| [&hand[0], &hand[2]]);
        let indices: BTreeSet<_> = of_both.map(|variant| (variant.style, variant.index)).collect();
        assert_eq!(indices.len(), 24);
        let widest = class.places.iter().map(|place| place.figures.1 - place.figures.0).max().unwrap();
        let spread = totals.iter().max().unwrap() - totals.iter().min().unwrap();
        assert!(spread <= widest, "of all questions together {spread}, of one {widest}: {totals:?}");
    }
}

#[test]
fn answers_come_twice_only_where_there_are_no_others() {
    let contents = Contents::shipped();
    let question = |id: &str| -> Question {
        contents.headings.iter().find(|heading| heading.id == id).unwrap().question().unwrap_or_else(|_| panic!("{id}"))
    };
    let answers = |question: &Question, hands: &[Vec<carom::generate::Variant>]| -> Vec<String> {
        hands.iter().map(|hand| Candidate::of(question, &hand[0]).unwrap().answers).collect()
    };
    let different = |answers: &[String]| answers.iter().collect::<BTreeSet<_>>().len();
    // Of each of them others have the same answers, and of the last, where a result is shown, all have.
    for (id, students, expected) in [
        ("rest/speeds-and-directions", 24, 24),
        ("i-j/velocities-after-impact", 24, 24),
        ("direct/restitution-from-one-speed", 24, 24),
        ("deflection/equal-masses", 12, 1),
    ] {
        let question = question(id);
        let style = Some(question.styles[0].name);
        let class = deal(&[&question], students, 3, style, &[]).unwrap();
        let dealt = answers(&question, &class.hands);
        assert_eq!((different(&dealt), class.places[0].different), (expected, expected), "{id}");
        // Who joins later has none of the answers of the others, as long as there are any.
        let had: Vec<Vec<_>> = class.hands.iter().map(|hand| vec![(hand[0].style, hand[0].index.unwrap())]).collect();
        let joined = deal(&[&question], 2, 3, style, &had).unwrap();
        let of_both: Vec<String> = dealt.into_iter().chain(answers(&question, &joined.hands)).collect();
        let further = if expected == 1 { 0 } else { 2 };
        assert_eq!((different(&of_both), joined.places[0].different), (expected + further, further), "{id}");
        // The same seed deals the same again.
        let again = deal(&[&question], students, 3, style, &[]).unwrap();
        assert_eq!(answers(&question, &again.hands), answers(&question, &class.hands), "{id}");
    }
}

#[test]
fn a_teacher_is_told_where_answers_come_twice() {
    let folder = folder("twice");
    let output = made(class(
        &folder,
        numbered(12),
        &["deflection/equal-masses", "--style", "friendly", "--seed", "3", "--format", "text"],
    ));
    let said = "`deflection/equal-masses`: 1 different answer for 12 students";
    assert!(stderr(&output).contains(said), "{}", stderr(&output));
}

#[test]
fn a_name_that_is_too_long_for_any_page_is_refused() {
    let folder = folder("long-name");
    for list in
        [format!("student,name\n1,{}\n2,Ben\n", "A".repeat(50_000)), format!("student\n{}\nBen\n", "A".repeat(50_000))]
    {
        let output = class(&folder, list, &["5C-2", "--seed", "1", "--format", "text"]);
        assert_eq!(output.status.code(), Some(1));
        let said = stderr(&output);
        assert!(said.contains("line 2: `AAAA") && said.contains("has 50000 characters"), "{said}");
        assert!(said.contains("has at most 20000") && said.len() < 1000, "{said}");
        assert!(!folder.join("sheet").exists());
    }
}

#[test]
fn the_same_command_prints_the_same_sheets_again_and_fresh_ones_for_who_is_new() {
    let folder = folder("lock");
    let options = ["--count", "2", "--format", "html"];
    made(class(&folder, "student\nAda\nBen\nCleo\n", &options));
    let read = |name: &str| fs::read(folder.join("sheet").join(name)).unwrap();
    let before: Vec<Vec<u8>> = ["question-sheets.html", "key.json", "lock.json"].map(read).to_vec();
    let again = made(class(&folder, "student\nAda\nBen\nCleo\n", &options));
    assert!(stderr(&again).contains("3 sheets as `sheet/lock.json` has them, 0 fresh"), "{}", stderr(&again));
    assert!(before == ["question-sheets.html", "key.json", "lock.json"].map(read).to_vec());

    let old: BTreeMap<String, String> = codes(&folder);
    made(class(&folder, "student\nDan\nCleo\nAda\n", &options));
    let new = codes(&folder);
    assert_eq!((&new["Ada"], &new["Cleo"]), (&old["Ada"], &old["Cleo"]));
    assert!(!old.values().any(|code| *code == new["Dan"]), "also not that of Ben, who has left");
    assert_eq!(json(folder.join("sheet/lock.json"))["sheets"].as_array().unwrap().len(), 4);
    // And Ben comes back.
    made(class(&folder, "student\nBen\n", &options));
    assert_eq!(codes(&folder)["Ben"], old["Ben"]);

    for (options, said) in [
        (&["5C-1", "--format", "html"][..], "with other questions"),
        (&["--count", "2", "--seed", "99999999", "--format", "html"], "with seed"),
    ] {
        let refused = class(&folder, "student\nAda\n", options);
        assert_eq!(refused.status.code(), Some(1));
        assert!(stderr(&refused).contains(said), "{}", stderr(&refused));
    }
    let lock = fs::read_to_string(folder.join("sheet/lock.json")).unwrap();
    fs::write(folder.join("sheet/lock.json"), lock.replacen("\"index\": ", "\"index\": 1", 1)).unwrap();
    let edited = class(&folder, "student\nBen\n", &options);
    assert!(stderr(&edited).contains("cannot be printed again"), "{}", stderr(&edited));
    fs::write(folder.join("sheet/lock.json"), "{\n  \"seed\": \"x\"\n}").unwrap();
    let broken = class(&folder, "student\nBen\n", &options);
    assert!(stderr(&broken).contains("lock.json:2:"), "{}", stderr(&broken));
}

fn codes(folder: &Path) -> BTreeMap<String, String> {
    let text = |json: &Json| json.as_str().unwrap().to_owned();
    papers(folder).iter().map(|paper| (text(&paper["student"]), text(&paper["code"]))).collect()
}

#[test]
fn a_class_that_is_larger_than_the_pool_hears_so_before_anything_is_printed() {
    let folder = folder("large");
    let output = class(&folder, numbered(120), &["5C-4", "--style", "friendly", "--format", "html"]);
    assert_eq!(output.status.code(), Some(1));
    let said = stderr(&output);
    let contents = Contents::shipped();
    let heading = contents.headings.iter().find(|heading| heading.mirrors.as_deref() == Some("5C-4")).unwrap();
    let question = heading.question().unwrap_or_else(|_| panic!());
    let style = question.styles.iter().find(|style| style.name.name() == "friendly").unwrap();
    let fit = (0..style.size()).filter(|index| examine(&question, style, *index).is_ok()).count();
    assert!(said.contains(&format!("has {fit} friendly sets of numbers to deal, and 120 students")), "{said}");
    assert!(said.contains("most are turned away since ") && said.contains(&format!("of {}", style.size())), "{said}");
    assert!(!folder.join("sheet").exists());
    // With as many as there are it goes.
    made(class(&folder, numbered(fit), &["5C-4", "--style", "friendly", "--format", "text"]));
    let numbers: BTreeSet<String> =
        papers(&folder).iter().map(|paper| paper["questions"][0]["parameters"].to_string()).collect();
    assert_eq!(numbers.len(), fit);
}

#[test]
fn a_list_that_is_wrong_is_refused_with_all_its_faults_and_nothing_is_written() {
    let folder = folder("wrong");
    let utf_16: Vec<u8> = "student\nAda\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let with_mark = [&[0xff, 0xfe][..], &utf_16].concat();
    let cases: [(&[u8], &[&str]); 10] = [
        (b"student,name\n1,Ada\n2,Ben\n1,Cleo\n", &["`1` is in the list twice", "class.csv:4", "line 2"]),
        (b"student,name\n1,Ada\n,Ben\n 1 ,Cleo\n", &["a row without a student", "`1` is in the list twice"]),
        ("student\nAda\nA\u{202e}da\n".as_bytes(), &["`Ada` is in the list twice"]),
        (b"student\n", &["nobody is in this class"]),
        (b"", &["no column `student`"]),
        (b"pupil,class\nAda,12\n", &["no column `student`", "student,name"]),
        (b"studnet\nAda\n", &["no column `student`", "`student` is meant, perhaps"]),
        (b"student\nZo\xeb\n", &["is not in UTF-8: line 2", "Latin-1"]),
        (&with_mark, &["is in UTF-16"]),
        (b"student,name\n1,\"Ada\n2,Ben\n", &["a quote is opened here and never closed"]),
    ];
    for (list, said) in cases {
        let output = class(&folder, list, &["--format", "html"]);
        let text = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{text}");
        said.iter().for_each(|said| assert!(text.contains(said), "{said} in\n{text}"));
        assert!(!folder.join("sheet").exists());
    }
    assert_eq!(carom(&folder, &["sheet", "--per-student"]).status.code(), Some(2));
    let output = class(&folder, "student\nAda\n", &["5C-2", "--per-student", "--format", "pdf"]);
    assert!(stderr(&output).contains("`--per-student` has nothing for the folder of a student"), "{}", stderr(&output));
    assert!(output.status.code() == Some(1) && !folder.join("sheet").exists());
    let missing = carom(&folder, &["sheet", "--class", "none.csv"]);
    assert!(stderr(&missing).contains("`none.csv` cannot be read: there is no such file"), "{}", stderr(&missing));
}

#[test]
fn lists_are_read_as_spreadsheets_save_them() {
    let folder = folder("saved");
    for list in [
        "\u{feff}student;name\r\n1;Ada\r\n2;Ben\r\n",
        "Name,Student\nAda,1\n\n\nBen,2\n",
        "id\tstudent\tname\nx\t1\tAda\ny\t2\tBen",
    ] {
        let _ = fs::remove_dir_all(folder.join("sheet"));
        made(class(&folder, list, &["5C-2", "--seed", "1", "--format", "text"]));
        let papers = papers(&folder);
        let who: Vec<(&str, &str)> =
            papers.iter().map(|paper| (paper["student"].as_str().unwrap(), paper["name"].as_str().unwrap())).collect();
        assert_eq!(who, [("1", "Ada"), ("2", "Ben")], "{list:?}");
    }
    let _ = fs::remove_dir_all(folder.join("sheet"));
    made(class(&folder, "name\nAda Lovelace\n", &["5C-2", "--seed", "1", "--format", "text"]));
    assert_eq!(papers(&folder)[0]["student"], "Ada Lovelace");
}

/// Names that would break a page, leave a folder, run in a spreadsheet or turn the direction of writing.
fn nasty() -> Vec<String> {
    let names = [
        r"}\input{/etc/passwd}$&#_^~%\",
        "<script>alert(1)</script>",
        "../../../etc/passwd",
        "C:\\Windows\\con",
        "=HYPERLINK(\"http://x\";\"y\")",
        "+1+1",
        "@SUM(A1)",
        "-2+3",
        "{{ title }} <% include \"x\" %> <<title>>",
        "Ada\u{202e}ecalevoL",
        "Zoë 中文 𝒜",
        "'quoted'",
        "\t=1+1",
        "nul\0l",
    ];
    names.into_iter().map(str::to_owned).chain(["long ".repeat(2000), "x".repeat(10_000)]).collect()
}

#[test]
fn no_name_breaks_a_page_leaves_the_folder_or_loses_its_marks() {
    let folder = folder("nasty");
    let names = nasty();
    let quoted = |text: &String| format!("\"{}\"", text.replace('"', "\"\""));
    let rows: Vec<String> = names.iter().map(|name| format!("{}\n", quoted(name))).collect();
    let list = format!("student\n{}", rows.concat());
    made(class(&folder, list, &["5C-2", "--seed", "1", "--format", "latex,html,text", "--per-student"]));
    let beside: BTreeSet<String> =
        fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert_eq!(beside, BTreeSet::from(["class.csv".to_owned(), "sheet".to_owned()]));
    let students: Vec<PathBuf> =
        fs::read_dir(folder.join("sheet/students")).unwrap().map(|e| e.unwrap().path()).collect();
    assert_eq!(students.len(), names.len());
    assert!(students.iter().all(|student| student.join("question-sheet.html").is_file()));
    for file in ["question-sheets", "mark-schemes", "worked-solutions-by-student", "teachers-key"] {
        let tex = fs::read_to_string(folder.join(format!("sheet/{file}.tex"))).unwrap();
        assert!(!tex.contains(r"\input{") && !tex.contains('\u{202e}'), "{file}");
        let html = fs::read_to_string(folder.join(format!("sheet/{file}.html"))).unwrap();
        assert!(!html.contains("<script") && !html.contains("xxxxxxxxxx".repeat(100).as_str()), "{file}");
        assert!(html.contains("{{ title }}"), "what a student is called is no template");
    }
    let table = fs::read_to_string(folder.join("sheet/submissions.csv")).unwrap();
    let starts = table.lines().skip(1).map(|line| line.trim_start_matches('"'));
    assert!(starts.clone().count() > 50 && starts.clone().all(|line| !line.starts_with(['=', '+', '-', '@'])));

    // Filled in with what is right, every one of them earns all marks.
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let papers = papers(&folder);
    let mut writer = csv::Writer::from_path(folder.join("filled.csv")).unwrap();
    writer.write_record(["student", "question", "part", "blank", "answer", "working"]).unwrap();
    let mut last = (String::new(), 0, 0);
    for record in reader.records().map(Result::unwrap) {
        let place = if last.0 == record[0] {
            (record[0].to_owned(), last.1, last.2 + 1)
        } else {
            (record[0].to_owned(), last.1 + usize::from(!last.0.is_empty()), 0)
        };
        let blank = &papers[place.1]["questions"][0]["parts"][0]["blanks"][place.2];
        assert_eq!(blank["name"], record[3]);
        writer
            .write_record([&record[0], &record[1], &record[2], &record[3], blank["rounded"].as_str().unwrap(), ""])
            .unwrap();
        last = place;
    }
    writer.flush().unwrap();
    let marked = made(carom(&folder, &["mark", "sheet/key.json", "filled.csv", "--json", "--feedback", "none"]));
    let summary: Json = serde_json::from_slice(&marked.stdout).unwrap();
    assert_eq!((&summary["students"], &summary["not_marked"]), (&names.len().into(), &0.into()), "{}", stderr(&marked));
    assert_eq!(summary["mean"].as_f64(), Some(11.0));
}

#[test]
fn a_code_prints_the_sheet_again_and_is_as_good_as_its_key() {
    let folder = folder("code");
    made(carom(&folder, &["sheet", "5C-2", "5C-9", "--seed", "3", "--out", "first"]));
    let code = json(folder.join("first/key.json"))["code"].as_str().unwrap().to_owned();
    made(carom(&folder, &["sheet", "--code", &code.to_lowercase(), "--out", "again"]));
    for entry in fs::read_dir(folder.join("first")).unwrap().map(Result::unwrap) {
        let again = fs::read(folder.join("again").join(entry.file_name())).unwrap();
        let same = again == fs::read(entry.path()).unwrap();
        assert!(same || entry.file_name() == "key.json", "{:?}", entry.file_name());
    }
    let questions = |name: &str| json(folder.join(name).join("key.json"))["questions"].clone();
    assert_eq!(questions("first"), questions("again"));

    let blank = &questions("first")[0]["parts"][0]["blanks"][0];
    let answer =
        format!("student,question,part,blank,answer\nAda,1,,speed of A,{}\n", blank["rounded"].as_str().unwrap());
    fs::write(folder.join("answers.csv"), answer).unwrap();
    made(carom(&folder, &["mark", "first/key.json", "answers.csv", "--out", "by-key"]));
    made(carom(&folder, &["mark", &code, "answers.csv", "--out", "by-code"]));
    let marks = |name: &str| fs::read(folder.join(name).join("marks.jsonl")).unwrap();
    assert!(marks("by-key") == marks("by-code") && !marks("by-key").is_empty());

    let mut slip: Vec<char> = code.chars().collect();
    slip.swap(0, 1);
    let slip: String = slip.into_iter().collect();
    for arguments in [["sheet", "--code", slip.as_str()].as_slice(), &["mark", slip.as_str(), "answers.csv"]] {
        let refused = carom(&folder, arguments);
        assert_eq!(refused.status.code(), Some(1));
        assert!(stderr(&refused).contains("mistyped"), "{}", stderr(&refused));
    }
    assert_eq!(carom(&folder, &["sheet", "5C-2", "--code", &code]).status.code(), Some(2));

    // A student of a class has a sheet that can be had alone.
    made(class(&folder, "student\nAda\nBen\n", &["5C-2", "--seed", "1", "--format", "text", "--per-student"]));
    let bens = codes(&folder)["Ben"].clone();
    made(carom(&folder, &["sheet", "--code", &bens, "--format", "text", "--out", "ben"]));
    let questions = |path: &str| {
        let text = fs::read_to_string(folder.join(path)).unwrap();
        text[text.find("Question 1").unwrap()..].to_owned()
    };
    assert_eq!(questions("ben/question-sheet.txt"), questions("sheet/students/ben/question-sheet.txt"));
}

#[test]
fn a_format_without_documents_for_a_class_says_so() {
    let folder = folder("format");
    fs::create_dir_all(folder.join("templates/plain")).unwrap();
    let manifest = "about = \"x\"\nnotation = \"unicode\"\n[[documents]]\nfile = \"a.txt\"\ntemplate = \"a.txt\"\n";
    fs::write(folder.join("templates/plain/format.toml"), manifest).unwrap();
    fs::write(folder.join("templates/plain/a.txt"), "{{ title }}").unwrap();
    let output = class(&folder, "student\nAda\n", &["5C-2", "--templates", "templates", "--format", "plain"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains("the format `plain` has no documents for a class"), "{}", stderr(&output));
    assert!(!folder.join("sheet").exists());
}

#[test]
fn the_commands_of_the_readme_make_a_class_and_one_sheet_again() {
    let folder = folder("readme");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    fs::create_dir_all(folder.join("examples")).unwrap();
    fs::copy(root.join("examples/class.csv"), folder.join("examples/class.csv")).unwrap();
    let page = fs::read_to_string(root.join("README.md")).unwrap();
    let section = page.split("\n## A class\n").nth(1).unwrap().split("\n## ").next().unwrap();
    // Plain tests know no TeX.
    let commands = section.lines().filter_map(|line| line.strip_prefix("$ carom "));
    let commands: Vec<String> = commands.map(|command| command.replace("--format pdf", "--format text")).collect();
    assert_eq!(commands.len(), 3);
    let run = |command: &str| made(carom(&folder, &command.split_whitespace().collect::<Vec<_>>()));
    run(&commands[0]);
    let lock = json(folder.join("class-sheets/lock.json"));
    assert_eq!(lock["sheets"].as_array().unwrap().len(), 30);
    run(&commands[1]);
    let sheet = json(folder.join("again/key.json"));
    assert_eq!(sheet["questions"][0]["mirrors"], "5C-2");
    let table = folder.join("again/submissions.csv");
    let filled = fs::read_to_string(&table).unwrap().replacen("\n,1,,speed of A,,", "\nAda,1,,speed of A,2.78,", 1);
    fs::write(&table, filled).unwrap();
    let marked = run(&commands[2]);
    assert!(String::from_utf8(marked.stdout).unwrap().contains("1 student"));

    let schema = json(root.join("docs/schema/lock.schema.json"));
    let fields = |json: &Json| -> BTreeSet<String> { json.as_object().unwrap().keys().cloned().collect() };
    assert_eq!(fields(&lock), fields(&schema["properties"]));
    let sheet = &lock["sheets"][0];
    assert_eq!(fields(sheet), fields(&schema["$defs"]["sheet"]["properties"]));
    assert_eq!(fields(&sheet["questions"][0]), fields(&schema["$defs"]["question"]["properties"]));
}

/// Everything in a folder and below it.
fn tree(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            found.extend(tree(&path));
        } else {
            found.insert(path.clone(), fs::read(&path).unwrap());
        }
    }
    found
}

/// Says this and one thing to try, and changes nothing in the folder.
fn refused(folder: &Path, output: impl FnOnce() -> Output, said: &str) {
    let before = tree(folder);
    let output = output();
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{text}");
    assert!(text.contains(said) && text.contains("help: "), "{said} in\n{text}");
    assert!(before == tree(folder), "{said}");
}

#[test]
fn a_lock_that_is_named_does_not_cost_the_one_that_lies_in_the_folder() {
    let folder = folder("two-locks");
    let options = ["5C-2", "--format", "text"];
    made(class(&folder, "student\nAda\nBen\n", &[&options[..], &["--seed", "1", "--out", "a"]].concat()));
    made(class(&folder, "student\n7\n8\n", &[&options[..], &["--seed", "5", "--out", "b"]].concat()));
    let with_lock = |students: &str, out: &str| {
        class(&folder, students, &[&options[..], &["--lock", "a/lock.json", "--out", out]].concat())
    };
    fs::write(folder.join("class.csv"), "student\nAda\nBen\n").unwrap();
    let said = "`b/lock.json` would lose the sheet of `7` and of 1 more";
    refused(&folder, || with_lock("student\nAda\nBen\n", "b"), said);
    // The lock of the folder by its name, or one that it holds whole, loses nobody.
    made(with_lock("student\nAda\nBen\n", "a"));
    made(with_lock("student\nAda\nBen\n", "c"));
    made(with_lock("student\nAda\nBen\nCy\n", "c"));
}

#[test]
fn a_lock_of_another_bank_or_of_a_later_version_is_not_used_in_silence() {
    let folder = folder("other-lock");
    let options = ["5C-2", "--format", "text", "--seed", "1"];
    made(class(&folder, "student\nAda\n", &options));
    let lock = fs::read_to_string(folder.join("sheet/lock.json")).unwrap();
    let own = env!("CARGO_PKG_VERSION");
    fs::write(folder.join("sheet/lock.json"), lock.replace(own, "999.1.0")).unwrap();
    let again = || class(&folder, "student\nAda\n", &options);
    refused(&folder, again, "`sheet/lock.json` was written by carom 999.1.0");
    fs::write(folder.join("sheet/lock.json"), lock.replace(own, "banana")).unwrap();
    refused(&folder, again, "this is no lock of a class: `banana` is no version of carom");
    fs::write(folder.join("sheet/lock.json"), lock.replace("shipped", "mine")).unwrap();
    let said = stderr(&made(again()));
    assert!(said.contains("`sheet/lock.json` is of sheets from the bank `mine`, and this is `shipped`"), "{said}");
}

#[test]
fn answers_never_come_to_lie_beside_the_key_of_another_sheet() {
    let folder = folder("other-sheet");
    let sheet = |question: &str, seed: &str| {
        carom(&folder, &["sheet", question, "--seed", seed, "--format", "text", "--out", "ov"])
    };
    fs::write(folder.join("class.csv"), "student\nAda\n").unwrap();
    made(sheet("5C-2", "1"));
    made(sheet("5C-3", "2"));
    let code = json(folder.join("ov/key.json"))["code"].as_str().unwrap().to_owned();
    let table = folder.join("ov/submissions.csv");
    fs::write(&table, "student,question,blank,answer\nAda,1,speed of A,2.78\n").unwrap();
    let said = format!("`ov/submissions.csv` has answers in it, and they are to the sheet {code}");
    refused(&folder, || sheet("5C-2", "1"), &said);
    refused(&folder, || sheet("5C-3", "3"), &said);
    refused(&folder, || class(&folder, "student\nAda\n", &["5C-3", "--out", "ov"]), &said);
    // The same sheet again, in other formats perhaps, leaves them.
    assert!(stderr(&made(sheet("5C-3", "2"))).contains("is left as it is"));
    fs::remove_file(folder.join("ov/key.json")).unwrap();
    refused(&folder, || sheet("5C-3", "2"), "no `key.json` beside it says to which sheet");

    // A class that others join, or leave, keeps its sheets and so its answers.
    made(class(&folder, "student\nAda\nBen\n", &["5C-2", "--seed", "1", "--format", "text"]));
    let filled = fs::read_to_string(folder.join("sheet/submissions.csv")).unwrap().replacen(",,\n", ",2.78,\n", 1);
    fs::write(folder.join("sheet/submissions.csv"), filled).unwrap();
    assert!(stderr(&made(class(&folder, "student\nAda\nCy\n", &["5C-2"]))).contains("is left as it is"));
    fs::remove_file(folder.join("sheet/lock.json")).unwrap();
    fs::write(folder.join("class.csv"), "student\nAda\nBen\n").unwrap();
    let others = || class(&folder, "student\nAda\nBen\n", &["5C-2", "--seed", "2"]);
    refused(&folder, others, "they are to the sheets of another class");
}

#[test]
fn an_empty_table_is_written_anew_whoever_is_in_it() {
    let folder = folder("empty-table");
    for list in ["student\nAda\nBen\n", "student\nCy\n", "student\nCy\nDan\n"] {
        let output = made(class(&folder, list, &["5C-2", "--seed", "1", "--format", "text"]));
        assert!(!stderr(&output).contains("has answers"), "{}", stderr(&output));
    }
    assert!(fs::read_to_string(folder.join("sheet/submissions.csv")).unwrap().contains("\nDan,1,"));
}

#[test]
fn nothing_is_written_over_that_somebody_else_wrote() {
    for (name, text) in [("key.json", "{\"door\": 7}"), ("question-sheet.html", "<p>my own</p>")] {
        let folder = folder("not-ours");
        fs::create_dir_all(folder.join("own")).unwrap();
        fs::write(folder.join("own").join(name), text).unwrap();
        let said = format!("`own/{name}` would be written over, and no `key.json` of Carom's is beside it");
        refused(&folder, || carom(&folder, &["sheet", "5C-2", "--seed", "1", "--out", "own"]), &said);
    }
    let folder = folder("not-ours");
    fs::write(folder.join("notes.txt"), "my own").unwrap();
    made(carom(&folder, &["sheet", "5C-2", "--seed", "1", "--out", "."]));
}

#[test]
fn what_is_left_of_earlier_sheets_is_told_by_its_names() {
    let folder = folder("left");
    let options = ["5C-2", "--seed", "1", "--format", "text", "--per-student"];
    made(class(&folder, "student\nben\nben 2\n", &options));
    let output = made(class(&folder, "student\nben\n", &options));
    assert!(stderr(&output).contains("`sheet/students/ben-2` is of an earlier sheet"), "{}", stderr(&output));
    let sheet = |question: &str, format: &str| {
        stderr(&made(carom(&folder, &["sheet", question, "--seed", "1", "--format", format, "--out", "one"])))
    };
    sheet("5C-2", "text,html");
    assert!(!sheet("5C-2", "text").contains("earlier"), "it is the same sheet");
    let said = sheet("5C-3", "text");
    assert!(said.contains("`one/mark-scheme.html`, `one/question-sheet.html`, ") && said.contains("are of an earlier"));
}
