//! The binary as a teacher meets it: every command, its exit code, and what it says of inputs that are wrong.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use serde_json::Value as Json;

fn carom(arguments: &[&str]) -> Output {
    // What `check` remembers belongs beside the other files of these tests.
    let cache = std::env::temp_dir().join(format!("carom-cli-cache-{}", std::process::id()));
    Command::new(env!("CARGO_BIN_EXE_carom")).args(arguments).env("XDG_CACHE_HOME", cache).output().unwrap()
}

fn with_stdin(arguments: &[&str], input: &[u8]) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // A program that refuses its input may close it before it has read all.
    let _ = child.stdin.take().unwrap().write_all(input);
    child.wait_with_output().unwrap()
}

fn code(output: &Output) -> i32 {
    output.status.code().expect("no signal")
}

fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// An empty folder of this test's own.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cli-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn sheet(out: &Path, more: &[&str]) -> Output {
    let mut arguments = vec!["sheet", "--out", out.to_str().unwrap()];
    arguments.extend(more);
    carom(&arguments)
}

fn key(folder: &Path) -> Json {
    serde_json::from_str(&fs::read_to_string(folder.join("key.json")).unwrap()).unwrap()
}

const FILES: [&str; 8] = [
    "question-sheet.tex",
    "worked-solutions.tex",
    "mark-scheme.tex",
    "question-sheet.html",
    "worked-solutions.html",
    "mark-scheme.html",
    "key.json",
    "submissions.csv",
];

#[test]
fn carom_knows_the_same_sheet_by_its_seed() {
    let folder = folder("seed");
    let [a, b, c] = ["a", "b", "c"].map(|name| folder.join(name));
    assert_eq!(code(&sheet(&a, &["--seed", "7"])), 0);
    assert_eq!(code(&sheet(&b, &["--seed", "7"])), 0);
    assert_eq!(code(&sheet(&c, &["--seed", "8"])), 0);
    let read = |folder: &Path, name: &str| fs::read(folder.join(name)).unwrap();
    for name in FILES {
        assert!(read(&a, name) == read(&b, name), "{name}");
        assert!(read(&a, name) != read(&c, name) || name == "submissions.csv", "{name}");
    }
    // Nothing else is left behind, hidden or not.
    assert_eq!(fs::read_dir(&a).unwrap().count(), FILES.len());
    assert_eq!(key(&a)["questions"].as_array().unwrap().len(), 6);
    assert_eq!(key(&a)["seed"], 7);
}

#[test]
fn a_sheet_says_what_it_wrote_and_the_seed_that_the_clock_gave() {
    let folder = folder("fresh");
    let first = sheet(&folder.join("a"), &["--format", "html"]);
    assert_eq!(stdout(&first).lines().count(), 5);
    for path in stdout(&first).lines() {
        assert!(Path::new(path).is_file(), "{path}");
    }
    let said = stderr(&first);
    let seed = said.split("--seed ").nth(1).unwrap().split('`').next().unwrap();
    assert_eq!(code(&sheet(&folder.join("b"), &["--format", "html", "--seed", seed])), 0);
    let read = |name: &str| fs::read(folder.join(name).join("mark-scheme.html")).unwrap();
    assert!(read("a") == read("b"));
}

#[test]
fn carom_knows_the_exercises_with_their_own_numbers() {
    let folder = folder("reference");
    let output = sheet(&folder, &["--reference"]);
    assert_eq!((code(&output), stderr(&output).contains("17 questions")), (0, true), "{}", stderr(&output));
    let key = key(&folder);
    let mirrors: Vec<&str> =
        key["questions"].as_array().unwrap().iter().map(|question| question["mirrors"].as_str().unwrap()).collect();
    let mut expected: Vec<String> = (1..=16).map(|number| format!("5C-{number}")).collect();
    expected.push("5C-challenge".into());
    assert_eq!(mirrors, expected);
    // Exercise 2 of the seed.
    let blanks = &key["questions"][1]["parts"][0]["blanks"];
    assert_eq!(blanks[0]["exact"], "4*sqrt(39)/9");
    assert_eq!((&blanks[0]["rounded"], &blanks[0]["unit"]), (&"2.78".into(), &"m/s".into()));
    assert_eq!((&blanks[1]["rounded"], &blanks[1]["reference"]), (&"46.1".into(), &"line of centres".into()));
    // Exercise 9: a vector.
    let velocity = &key["questions"][8]["parts"][0]["blanks"][0];
    assert_eq!(velocity["find"], serde_json::json!(["A.after.x", "A.after.y"]));
    assert_eq!(velocity["exact"], serde_json::json!(["4", "1"]));
    // Exercise 6: what is to be shown.
    let shown = &key["questions"][5]["parts"][0]["blanks"][0];
    assert_eq!((&shown["kind"], &shown["decimal"]), (&"shown".into(), &Json::Null));
    // A mark knows on what it depends, and to which answers it belongs.
    let scheme = key["questions"][1]["parts"][0]["scheme"].as_array().unwrap();
    let solve = scheme.iter().find(|mark| mark["for"] == "solve").unwrap();
    assert_eq!((&solve["code"], &solve["depends"]), (&"dM1".into(), &serde_json::json!(["M1a", "M1b"])));
    assert_eq!(solve["blanks"].as_array().unwrap().len(), 4);
    let perpendicular = scheme.iter().find(|mark| mark["for"] == "perpendicular").unwrap();
    assert_eq!(perpendicular["equation"], "4*sin(30*deg) = 2");
    let names = scheme.iter().filter(|mark| mark["for"] == "B.after.speed").map(|mark| &mark["blanks"]);
    assert_eq!(names.collect::<Vec<_>>(), [&serde_json::json!(["speed of B"])]);
}

#[test]
fn the_scene_of_every_question_of_a_key_gives_its_answers_again() {
    let folder = folder("again");
    for more in [&["--reference"][..], &["--count", "17", "--seed", "3"], &["--count", "17", "--seed", "4"]] {
        assert_eq!(code(&sheet(&folder, more)), 0);
        let key = key(&folder);
        for question in key["questions"].as_array().unwrap() {
            let scene = question["scene"].to_string();
            let output = with_stdin(&["solve", "-", "--json"], scene.as_bytes());
            assert_eq!(code(&output), 0, "{scene}: {}", stderr(&output));
            let solved: Json = serde_json::from_str(&stdout(&output)).unwrap();
            let blanks =
                question["parts"].as_array().unwrap().iter().flat_map(|part| part["blanks"].as_array().unwrap());
            for blank in blanks {
                let finds: Vec<&str> = match &blank["find"] {
                    Json::Array(list) => list.iter().filter_map(Json::as_str).collect(),
                    one => one.as_str().into_iter().collect(),
                };
                let exact: Vec<&Json> =
                    blank["exact"].as_array().map_or(vec![&blank["exact"]], |all| all.iter().collect());
                for (find, exact) in finds.iter().zip(exact) {
                    let again = &solved["quantities"][find]["exact"];
                    assert!(again.is_string(), "{find} of {scene}");
                    // Of a found letter the key holds what is shown about it.
                    if find.contains('.') {
                        assert_eq!(again, exact, "{find} of {scene}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_question_is_found_by_its_name_in_any_form() {
    let folder = folder("names");
    for name in ["5C-2", "5c-2", "rest/speeds-and-directions", "speeds-and-dir"] {
        assert_eq!(code(&sheet(&folder, &[name, "--seed", "1"])), 0, "{name}");
        assert_eq!(key(&folder)["questions"][0]["id"], "rest/speeds-and-directions");
    }
    let table = [
        ("rest/speeds-and-direction", 0, ""),
        ("speeds-and-directoins", 1, "did you mean `speeds-and-directions`?"),
        ("i-j", 1, "name one of `i-j/"),
        ("", 1, "unknown question"),
        ("momentum", 1, "carom list"),
    ];
    for (name, expected, words) in table {
        let output = sheet(&folder, &[name, "--seed", "1"]);
        assert_eq!(code(&output), expected, "{name}: {}", stderr(&output));
        assert!(stderr(&output).contains(words), "{name}: {}", stderr(&output));
    }
}

#[test]
fn one_question_thirty_times_has_thirty_sets_of_numbers() {
    let folder = folder("thirty");
    assert_eq!(code(&sheet(&folder, &["5C-5", "--count", "30", "--seed", "2", "--format", "html"])), 0);
    let key = key(&folder);
    let mut numbers: Vec<String> =
        key["questions"].as_array().unwrap().iter().map(|question| question["parameters"].to_string()).collect();
    assert_eq!(numbers.len(), 30);
    numbers.sort();
    numbers.dedup();
    assert_eq!(numbers.len(), 30);
}

#[test]
fn a_sheet_says_when_there_are_no_more_numbers() {
    let folder = folder("exhausted");
    let output = sheet(&folder, &["5C-6", "--count", "150", "--style", "friendly", "--format", "html"]);
    assert_eq!(code(&output), 0);
    assert!(stderr(&output).contains("no more than"), "{}", stderr(&output));
    assert!(key(&folder)["questions"].as_array().unwrap().len() < 150);
}

#[test]
fn marks_topics_and_styles_are_kept() {
    let folder = folder("choice");
    assert_eq!(code(&sheet(&folder, &["--marks", "40", "--seed", "5"])), 0);
    let marks = |key: &Json| -> u64 {
        let questions = key["questions"].as_array().unwrap().iter();
        questions
            .flat_map(|question| question["parts"].as_array().unwrap())
            .map(|part| part["marks"].as_u64().unwrap())
            .sum()
    };
    assert_eq!(marks(&key(&folder)), 40);
    assert_eq!(code(&sheet(&folder, &["--topic", "I and J", "--style", "friendly"])), 0);
    for question in key(&folder)["questions"].as_array().unwrap() {
        assert!(question["id"].as_str().unwrap().starts_with("i-j/"));
        assert_eq!(question["style"], "friendly");
    }
    let table = [
        (&["--topic", "springs"][..], 1, "the topics are"),
        (&["--marks", "3"], 1, "the shortest has"),
        (&["5C-4", "--style", "calculator"], 1, "it has"),
        (&["--style", "nice"], 2, "possible values"),
        (&["--count", "0"], 2, "0"),
        (&["--count", "3", "--marks", "3"], 2, "cannot be used with"),
        (&["--reference", "--seed", "3"], 2, "cannot be used with"),
        (&["--format", "word"], 1, "unknown format `word`"),
        (&["--bank", "no/such/bank"], 1, "no/such/bank"),
        (&["--templates", "no/such/templates"], 1, "no/such/templates"),
    ];
    for (arguments, expected, words) in table {
        let output = sheet(&folder, arguments);
        assert_eq!(code(&output), expected, "{arguments:?}: {}", stderr(&output));
        assert!(stderr(&output).contains(words), "{arguments:?}: {}", stderr(&output));
        assert!(!stderr(&output).contains("panicked"));
    }
}

#[test]
fn nothing_is_written_where_it_cannot_be_written_whole() {
    let folder = folder("unwritable");
    let file = folder.join("file");
    fs::write(&file, "mine").unwrap();
    for out in [file.clone(), file.join("below")] {
        let output = sheet(&out, &["--seed", "1"]);
        assert_eq!(code(&output), 1);
        assert!(stderr(&output).contains("cannot be made"), "{}", stderr(&output));
    }
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
    // Where one of the files cannot stand none is written, and what was there stays.
    let out = folder.join("out");
    assert_eq!(code(&sheet(&out, &["--seed", "1"])), 0);
    fs::remove_file(out.join("mark-scheme.html")).unwrap();
    fs::create_dir_all(out.join("mark-scheme.html")).unwrap();
    fs::write(out.join("question-sheet.tex"), "mine").unwrap();
    let output = sheet(&out, &["--seed", "1"]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("it is a folder"), "{}", stderr(&output));
    assert_eq!(fs::read_to_string(out.join("question-sheet.tex")).unwrap(), "mine");
    assert_eq!(fs::read_dir(&out).unwrap().count(), FILES.len());
}

const SCENE: &str = r#"{ "masses": {"A": "4", "B": "2"},
  "before": {"A": {"speed": "4", "angle_deg": "30"}, "B": ["0", "0"]},
  "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "1/3" }"#;

const SCENE_TOML: &str = r#"
masses = { A = "4", B = "2" }
line_of_centres = ["1", "0"]
e = "1/3"
[before]
A = { speed = "4", angle_deg = "30" }
B = ["0", "0"]
"#;

#[test]
fn a_scene_is_solved_from_json_and_from_toml() {
    let folder = folder("scenes");
    for (name, text) in [("scene.json", SCENE), ("scene.toml", SCENE_TOML)] {
        let path = folder.join(name);
        fs::write(&path, text).unwrap();
        let output = carom(&["solve", path.to_str().unwrap()]);
        assert_eq!(code(&output), 0, "{}", stderr(&output));
        assert!(stdout(&output).contains("Momentum is conserved along the line of centres:"));
        assert!(stdout(&output).contains("4√39/9 ≈ 2.78 m/s"), "{}", stdout(&output));
    }
    let output = with_stdin(&["solve", "-", "--json"], SCENE_TOML.as_bytes());
    let solved: Json = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!(solved["quantities"]["A.after.speed"]["exact"], "4*sqrt(39)/9");
    assert_eq!(solved["quantities"]["A.after.speed"]["decimal"], "2.77555466595484");
    let output = with_stdin(&["solve", "-", "--json", "--method", "float"], SCENE.as_bytes());
    let solved: Json = serde_json::from_str(&stdout(&output)).unwrap();
    let speed: f64 = solved["quantities"]["A.after.speed"]["decimal"].as_str().unwrap().parse().unwrap();
    assert!((speed - 2.77555466595484).abs() < 1e-13);
}

#[test]
fn an_error_that_is_proved_holds_for_the_decimal_as_it_is_printed() {
    let scene =
        r#"{"masses":{"A":"3","B":"10"},"before":{"A":["3","0"],"B":["0","0"]},"line_of_centres":["1","0"],"e":"1/2"}"#;
    for method in ["certified-float", "float-intervals", "intervals"] {
        let output = with_stdin(&["solve", "-", "--json", "--method", method], scene.as_bytes());
        let solution: Json = serde_json::from_str(&stdout(&output)).unwrap();
        let ratio = &solution["quantities"]["mass_ratio"];
        // 10/3 lies 1.67e-16 below this decimal, and 1.48e-16 below the double that prints so.
        assert_eq!(ratio["decimal"], "3.3333333333333335", "{method}");
        let error: f64 = ratio["error"].as_str().unwrap().parse().unwrap();
        assert!((1.67e-16..1e-15).contains(&error), "{method}: {error}");
    }
}

#[test]
fn a_scene_is_worked_out_by_the_least_that_suffices_or_by_the_method_asked_for() {
    let solved = |arguments: &[&str]| {
        let output = with_stdin(&[&["solve", "-", "--json"], arguments].concat(), SCENE.as_bytes());
        assert_eq!(code(&output), 0, "{arguments:?}: {}", stderr(&output));
        serde_json::from_str::<Json>(&stdout(&output)).unwrap()
    };
    let least = solved(&[]);
    assert_eq!([&least["method"], &least["geometry"]], ["surd-integers", "resolved along the line of centres"]);
    assert!(least["why"].as_str().unwrap().contains("integers would not do"), "{least}");
    for method in carom::method::METHODS {
        let name = method.name();
        if ["integers", "fractions", "ratio-from-integers"].contains(&name) {
            let output = with_stdin(&["solve", "-", "--method", name], SCENE.as_bytes());
            assert_eq!(code(&output), 1);
            assert!(stderr(&output).contains("a component of a velocity is n"), "{}", stderr(&output));
            continue;
        }
        let solution = solved(&["--method", name]);
        assert_eq!(solution["method"], name);
        let answer = &solution["quantities"]["A.after.speed"];
        let is_exact = method.promises() == carom::method::Promise::Exact;
        assert_eq!([answer.get("exact").is_some(), solution.get("steps").is_some()], [is_exact; 2], "{name}");
        let only_simulates = matches!(method.promises(), carom::method::Promise::Nothing(_));
        let remark = solution["remarks"][0].as_str().unwrap_or_default();
        assert_eq!(remark.contains("only simulates: components are off by up to "), only_simulates, "{name}: {remark}");
        let speed: f64 = answer["decimal"].as_str().unwrap().parse().unwrap();
        let allowed = match name {
            "single" => 1e-6,
            "fixed-step" | "spring-verlet" | "spring-runge-kutta" => 0.05,
            _ => 1e-13,
        };
        assert!((speed - 2.77555466595484).abs() < allowed, "{name}: {speed}");
    }
    let output = with_stdin(&["solve", "-"], SCENE.as_bytes());
    assert!(
        stdout(&output).contains("\nMethod\n  surd-integers (resolved along the line of centres): "),
        "{}",
        stdout(&output)
    );
    let output = with_stdin(&["solve", "-", "--method", "eliminaton"], SCENE.as_bytes());
    assert!(stderr(&output).contains("did you mean `elimination`?"), "{}", stderr(&output));
}

#[test]
fn what_has_too_many_roots_for_an_exact_form_has_decimals() {
    let scene = r#"{"masses": {"A": "1", "B": "2"}, "radii": {"A": "1", "B": "1"}, "impact_parameter": "1/2",
        "before": {"A": ["sqrt(2)", "sqrt(3)"], "B": ["-sqrt(5)", "sqrt(7)"]}, "e": "1/2"}"#;
    let by = |method: &str| with_stdin(&["solve", "-", "--method", method], scene.as_bytes());
    assert!(stderr(&by("exact")).contains("`A.after.x` ≈ -2.23 m/s"), "{}", stderr(&by("exact")));
    let decimals = stdout(&by("float"));
    assert!(decimals.contains(" -2.2290970583"), "{decimals}");
}

#[test]
fn a_simulation_says_where_it_is_too_coarse_and_is_not_slow_where_the_spheres_are() {
    let scene = |x: &str, y: &str| {
        let velocities = format!(r#"{{"A": ["{x}", "{y}"], "B": ["0", "0"]}}"#);
        let masses = r#"{"A": "4", "B": "1"}"#;
        format!(r#"{{"masses": {masses}, "before": {velocities}, "line_of_centres": ["1", "0"], "e": "1/2"}}"#)
    };
    let by = |scene: &str| with_stdin(&["solve", "-", "--method", "fixed-step"], scene.as_bytes());
    assert!(stdout(&by(&scene("60", "30"))).contains("% of the larger speed before: too coarse for this impact"));
    let slow = stdout(&by(&scene("10^(-9)", "0")));
    assert!(slow.contains("only simulates") && !slow.contains("too coarse"), "{slow}");
}

#[test]
fn velocities_before_and_after_determine_e_also_where_the_line_of_centres_has_a_long_form() {
    let scene = r#"{"masses": {"A": "2", "B": "4"}, "after": {"A": ["2", "0"], "B": null},
        "before": {"A": {"speed": "6", "angle_deg": "10"}, "B": ["0", "0"]}}"#;
    let output = with_stdin(&["solve", "-"], scene.as_bytes());
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    // e = 2(1 - cos 10°)/(3 - cos 10°), from the components along the change of the velocity of A.
    assert!(stdout(&output).contains("≈ 0.0151") && !stderr(&output).contains("left open"), "{}", stdout(&output));
}

#[test]
fn the_momentum_of_a_sphere_at_rest_is_a_product_and_no_number_of_two_digits() {
    let scene = r#"{"masses": {"A": "1", "B": "2"}, "before": {"A": ["5", "0"], "B": ["0", "0"]}, "after": {"A": ["1", "2"], "B": null}}"#;
    let output = with_stdin(&["solve", "-"], scene.as_bytes());
    assert!(stdout(&output).contains("5i + 2 × 0 = (i + 2j) + 2v_B"), "{}", stdout(&output));
}

#[test]
fn a_scene_that_cannot_be_solved_is_told_what_is_the_matter_with_it() {
    let scene = |masses: &str, velocity: &str, rest: &str| {
        let before = format!(r#""before": {{"A": {velocity}, "B": ["0", "0"]}}"#);
        format!(r#"{{"masses": {masses}, {before}{rest}}}"#)
    };
    let masses = r#"{"A": "1", "B": "1"}"#;
    let line = r#", "line_of_centres": ["1", "0"]"#;
    let asks = |condition: &str| {
        let unknown = r#""e": "x", "symbols": {"x": "unit"}, "unknowns": ["x"]"#;
        scene(masses, r#"["1", "1"]"#, &format!(r#"{line}, {unknown}, "conditions": ["{condition}"]"#))
    };
    let with = |rest: &str| scene(masses, r#"["1", "1"]"#, rest);
    const DEGREES: &str = r#"{"masses": {"A": "2", "B": "3"}, "line_of_centres": ["1", "0"], "e": "3/4",
        "before": {"A": {"speed": "6", "angle_deg": "x"}, "B": {"speed": "6", "angle_deg": "141"}},
        "symbols": {"x": "acute"}, "unknowns": ["x"], "conditions": ["A.deflection_deg = 40"]}"#;
    let many = r#"{"A": "sqrt(2)+sqrt(3)+sqrt(5)+sqrt(7)", "B": "3"}"#;
    for (scene, said) in [
        (scene(many, r#"["4", "1"]"#, &format!(r#"{line}, "e": "1/2""#)), "too many roots for an exact form"),
        (scene(many, r#"["4", "1"]"#, &format!(r#"{line}, "e": "1/2""#)), "`A.after.x` ≈ 2.37 m/s"),
        // No energy is lost, and no decimal of it is waited for.
        (scene(many, r#"["4", "1"]"#, &format!(r#"{line}, "e": "1""#)), "`ke.lost`\nhelp"),
        // That its coefficients have nothing in common with those of its derivative is proved in intervals, not waited for.
        (DEGREES.to_owned(), "an equation of degree 4"),
        (with(line), "there is no `e`"),
        (with(r#", "e": "1/2""#), "there is no `line_of_centres`"),
        (scene(r#"{"A": "1"}"#, r#"["1", "1"]"#, &format!(r#"{line}, "e": "1/2""#)), "there is no `masses.B`"),
        (scene(masses, "\"4i+j\"", &format!(r#"{line}, "e": "1/2""#)), r#"`["4", "1"]`"#),
        (
            with(r#", "line_of_centres": ["0", "0"], "e": "1/2""#),
            "help: give any vector from the one centre to the other",
        ),
        (with(&format!(r#"{line}, "e": "1/0""#)), "help: change what stands below the line"),
        (with(&format!(r#"{line}, "e": "sqrt(-1)""#)), "help: check the sign"),
        (scene(r#"{"A": "m", "B": "1"}"#, r#"["1", "1"]"#, r#", "symbols": {"m": "pos"}"#), "did you mean `positive`?"),
        (asks("A.after.angle_to_loc_deg = -60"), "this angle is from 0° to 90°"),
        (asks("A.deflection_deg = 200"), "this angle is from 0° to 180°"),
        (asks("A.deflection_signed_deg = 200"), "this angle is from −180° to 180°"),
        (asks("1 = 1"), "help: give as many conditions as unknowns"),
        (
            with(&format!(
                r#"{line}, "symbols": {{"k": "unit"}}, "unknowns": ["k"], "conditions": ["A.after.speed = 3"]"#
            )),
            "help: write it where the scene gives a value",
        ),
        ("[1, 2]".to_owned(), "expected `{` and the fields of a scene"),
    ] {
        let output = with_stdin(&["solve", "-"], scene.as_bytes());
        assert_eq!(code(&output), 1, "{scene}");
        assert!(stderr(&output).contains(said), "{scene}: {}", stderr(&output));
        assert_eq!(stderr(&output).matches("error: ").count(), 1, "{scene}: {}", stderr(&output));
    }
}

#[test]
fn letters_have_their_limits_in_masses_approach_and_restitution() {
    let scene = r#"{"masses": {"A": "m", "B": "m"}, "before": {"A": ["u", "0"], "B": ["0", "0"]}, "after": {"A": ["v", "0"]},
        "line_of_centres": ["1", "0"], "symbols": {"m": "positive", "u": "positive", "v": "positive"}}"#;
    let output = with_stdin(&["solve", "-"], scene.as_bytes());
    assert!(stdout(&output).contains("this needs (u − 2v)/u ≥ 0"), "{}", stdout(&output));
    let given = r#"{"masses": {"A": "m", "B": "x*m"}, "before": {"A": ["u", "0"], "B": ["w", "0"]}, "e": "k",
        "line_of_centres": ["1", "0"], "sense": "A_to_B",
        "symbols": {"m": "positive", "u": "positive", "w": "positive", "k": "positive", "x": "real"}}"#;
    let output = with_stdin(&["solve", "-"], given.as_bytes());
    for needed in ["this needs mx > 0", "this needs u − w > 0", "this needs k ≤ 1"] {
        assert!(stdout(&output).contains(needed), "{needed}: {}", stdout(&output));
    }
}

#[test]
fn letters_have_their_limits_in_every_impact_and_each_is_said_once() {
    let scene = r#"{"masses": {"A": "x", "B": "3"}, "before": {"A": "u", "B": "0"}, "e": "k",
        "symbols": {"u": "real", "x": "real", "y": "real", "w": "real", "k": "real", "f": "real"},
        "then": [{"of": ["B", "C"], "mass": "y", "before": "w", "e": "f"}, {"of": ["B"], "wall": ["0", "1"], "e": "k"}]}"#;
    let output = with_stdin(&["solve", "-"], scene.as_bytes());
    for needed in ["x > 0", "y > 0", "u > 0", "k ≥ 0", "k ≤ 1", "f ≥ 0", "f ≤ 1"] {
        let said = stdout(&output).matches(&format!("this needs {needed}")).count();
        assert_eq!(said, 1, "{needed}: {}", stdout(&output));
    }
    assert_eq!(stdout(&output).matches("this needs").count(), 9, "{}", stdout(&output));
}

#[test]
fn a_quotient_of_sums_with_letters_and_roots_is_left_one_in_lowest_terms() {
    let tangents = |mass: &str, rest: &str| {
        let scene = format!(
            r#"{{"masses": {{"A": "m", "B": "{mass}"}}, "before": {{"A": {{"speed": "u", "angle_deg": "30"}}, {rest},
            "symbols": {{"m": "positive", "k": "positive", "u": "positive", "e": "unit"}}}}"#
        );
        let output = with_stdin(&["solve", "-", "--json"], scene.as_bytes());
        let solution: Json = serde_json::from_str(&stdout(&output)).unwrap();
        ["A", "B"].map(|sphere| solution["quantities"][format!("{sphere}.after.tan_to_loc")]["exact"].clone())
    };
    let [a, _] = tangents("k*m", r#""B": ["-u", "0"]}, "line_of_centres": ["1", "0"], "e": "e""#);
    assert_eq!(a, "(1 + k)/abs(2*k - sqrt(3) + 2*e*k + sqrt(3)*e*k)");
    let [_, b] = tangents("sqrt(2)*k*m", r#""B": ["0", "-u"]}, "line_of_centres": ["1", "1"], "e": "1/3""#);
    let below = "12*k - 3*sqrt(2) - 2*sqrt(6) + 4*sqrt(3)*k - 6*sqrt(2)*k^2";
    assert_eq!(b, format!("3*sqrt(2)*abs(2*k^2 - 1)/abs({below})"));
}

#[test]
fn of_two_solutions_neither_is_said_to_be_impossible() {
    let scene = r#"{"masses": {"A": "2", "B": "1"}, "before": {"A": "x", "B": "0"}, "e": "1/2",
        "symbols": {"x": "positive"}, "unknowns": ["x"],
        "conditions": ["A.after.n^2 - 5*x*A.after.n/8 + 3*x/4 = 1"]}"#;
    let said = stdout(&with_stdin(&["solve", "-"], scene.as_bytes()));
    assert!(said.contains("So x = 6 + 2√5 or x = 6 − 2√5, both of which are possible; here:"), "{said}");
    assert!(said.contains("So x = 6 − 2√5 or x = 6 + 2√5, both of which are possible; here:"), "{said}");
    assert!(!said.contains("not possible"), "{said}");
}

#[test]
fn an_impossible_scene_is_refused_with_the_mechanics() {
    // Exercise 12 as it is printed: the spheres would pass through each other.
    let scene = r#"{"masses": {"A": "1", "B": "2"}, "before": {"A": ["2", "5"], "B": ["3", "-1"]}, "after": {"A": ["3", "2"]}}"#;
    for arguments in [&["solve", "-"][..], &["solve", "-", "--json"]] {
        let output = with_stdin(arguments, scene.as_bytes());
        assert_eq!(code(&output), 1);
        assert!(stderr(&output).starts_with("error: "), "{}", stderr(&output));
        assert!(stdout(&output).is_empty());
    }
}

#[test]
fn each_refusal_has_one_thing_to_try() {
    let letter = r#""symbols": {"e": "unit"}, "unknowns": ["e"]"#;
    let backwards = |rest: &str| {
        let motion = r#""before": {"A": ["4", "1"], "B": ["0", "0"]}, "line_of_centres": ["1", "0"], "e": "e""#;
        format!(r#"{{"masses": {{"A": "3", "B": "2"}}, {motion}, {letter}, {rest}}}"#)
    };
    let plain = |rest: &str| {
        format!(r#"{{"masses": {{"A": "4", "B": "2"}}, "before": {{"A": ["2", "-1"], "B": ["-2", "1"]}}, {rest}}}"#)
    };
    let later = |then: &str| plain(&format!(r#""line_of_centres": ["1", "0"], "e": "1", "then": [{then}]"#));
    for (scene, help) in [
        (plain(r#""after": {"A": ["10/3", "-5/3"]}"#), "the impulse on A is away from B"),
        (plain(r#""line_of_centres": ["-1", "0"], "sense": "A_to_B", "e": "1""#), "or leave out `sense`"),
        (plain(r#""impact_parameter": "9", "radii": {"A": "1", "B": "1"}, "e": "1""#), "a smaller `impact_parameter`"),
        (plain(r#""line_of_centres": ["1", "0"], "e": "1 = 1""#), "one of its sides alone"),
        (backwards(r#""conditions": ["A.after.n > -9"]"#), "that only some values meet"),
        (backwards(r#""maximise": "A.after.t""#), "a quantity that depends on it"),
        (later(r#"{"of": ["A"], "wall": ["0", "0"], "e": "1/2"}"#), "any vector along the wall"),
        (
            later(
                r#"{"of": ["A", "C"], "mass": "1", "before": ["0", "0"], "line_of_centres": ["0", "0"], "e": "1/2"}"#,
            ),
            "any vector from the one centre to the other",
        ),
        (later(r#"{"of": ["A"], "wall": ["0", "0"], "e": "1/0"}"#), "change what stands below the line"),
    ] {
        let output = with_stdin(&["solve", "-"], scene.as_bytes());
        assert_eq!(code(&output), 1, "{scene}");
        let said = stderr(&output);
        assert!(said.lines().any(|line| line.starts_with("help: ") && line.contains(help)), "{scene}: {said}");
    }
}

#[test]
fn hostile_scenes_are_refused_and_never_panic() {
    let folder = folder("hostile");
    let deep_json = format!("{}1{}", "[".repeat(5000), "]".repeat(5000));
    let deep_object = format!("{}1{}", r#"{"before":"#.repeat(3000), "}".repeat(3000));
    let deep_toml = format!("a = {}1{}", "[".repeat(5000), "]".repeat(5000));
    let deep_formula = format!(r#"{{"e": "{}1{}"}}"#, "(".repeat(5000), ")".repeat(5000));
    let long = format!(r#"{{"e": "{}"}}"#, "1+".repeat(600_000));
    let roots = format!(r#"{{"e": "{}1/2{}"}}"#, "sqrt(".repeat(20), ")".repeat(20));
    let angles: Vec<String> = (1..8).map(|degrees| format!("cos({degrees} deg)")).collect();
    let angles = format!(r#"{{"e": "{}"}}"#, angles.join("+"));
    let table: &[(&str, &[u8], &str)] = &[
        ("empty", b"", "is empty"),
        ("blank", b" \n\t", "is empty"),
        ("binary", b"\xff\xfe\x00\x01", "is no text"),
        ("nul", b"\0\0\0", "error"),
        ("words", b"hello there", "error"),
        ("nothing", b"{}", "error"),
        ("null", b"{\"masses\": null}", "error"),
        ("list", b"[]", "error"),
        ("open", b"{\"masses\": {\"A\": \"1\"", "this is no JSON"),
        ("number", b"{\"e\": 0.5}", "as a string"),
        ("velocity", b"{\"before\": {\"A\": [\"1\", \"2\", \"3\"]}}", "found 3"),
        ("unknown key", b"{\"mass\": {}}", "mass"),
        ("unknown letter", b"{\"e\": \"q\"}", "symbols"),
        (
            "quantity for a letter",
            b"{\"e\": \"approach\", \"symbols\": {\"approach\": \"unit\"}}",
            "no name of a letter",
        ),
        ("unknown toml key", b"mass = '1'", "mass"),
        ("duplicate", b"e = '1'\ne = '1'", "second time"),
        ("formula", b"{\"e\": \"1/(1-1)\"}", "error"),
        ("power", b"{\"e\": \"9^9^9^9\"}", "error"),
        ("deep json", deep_json.as_bytes(), "error"),
        ("deep object", deep_object.as_bytes(), "error"),
        ("deep toml", deep_toml.as_bytes(), "error"),
        ("deep formula", deep_formula.as_bytes(), "error"),
        ("long", long.as_bytes(), "too long"),
        ("roots", roots.as_bytes(), "too many roots within roots"),
        ("angles", angles.as_bytes(), "too many different angles"),
        ("caret after the end", "{\"e\": \"é\\u00e9+\"}".as_bytes(), "error"),
    ];
    for (name, input, words) in table {
        for ending in ["", ".json", ".toml"] {
            let path = folder.join(format!("scene{ending}"));
            fs::write(&path, input).unwrap();
            let output = if ending.is_empty() {
                with_stdin(&["solve", "-"], input)
            } else {
                carom(&["solve", path.to_str().unwrap()])
            };
            assert_eq!(code(&output), 1, "{name}{ending}: {}", stderr(&output));
            assert!(stderr(&output).contains("error"), "{name}{ending}: {}", stderr(&output));
            assert!(!stderr(&output).contains("panicked"), "{name}{ending}: {}", stderr(&output));
            if ending.is_empty() {
                assert!(stderr(&output).contains(words), "{name}: {}", stderr(&output));
            }
        }
    }
    for (path, words) in [(folder.join("none.json"), "cannot be read"), (folder.clone(), "it is a folder")] {
        let output = carom(&["solve", path.to_str().unwrap()]);
        assert_eq!(code(&output), 1);
        assert!(stderr(&output).contains(words), "{}", stderr(&output));
    }
    let output = with_stdin(&["solve", "-", "--method", "flaot"], SCENE.as_bytes());
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("`exact`, `float`"), "{}", stderr(&output));
}

#[test]
fn what_happens_later_can_happen_on_the_line_on_which_the_spheres_lie() {
    // A has 9/2 and B has 9 after the first impact, so that B runs ahead.
    let first = r#"{"masses": {"A": "4", "B": "2"}, "before": {"A": "9", "B": "0"}, "e": "1/2", "then": ["#;
    let c = |of: &str, before: &str| format!(r#"{{"of": [{of}], "mass": "4", "before": {before}, "e": "1"}}"#);
    let wall = |of: &str| format!(r#"{{"of": ["{of}"], "wall": ["0", "1"], "e": "1"}}"#);
    let again = |of: &str| format!(r#"{{"of": [{of}], "e": "1"}}"#);
    let table = [
        (c(r#""B", "C""#, r#""0""#), ""),
        (c(r#""C", "A""#, r#""20""#), ""),
        (format!("{}, {}", wall("B"), again(r#""A", "B""#)), ""),
        (c(r#""B", "C""#, r#"["3", "100"]"#), "a velocity in a plane among others along a line"),
        (c(r#""B", "C""#, r#"{"speed": "3", "angle_deg": "60"}"#), "a velocity in a plane among others along a line"),
        (again(r#""B", "A""#), "B and A are not next to each other in this order"),
        (c(r#""A", "C""#, r#""0""#), "on their line the spheres lie in the order A, B"),
        (c(r#""C", "B""#, r#""20""#), "C and B are not next to each other"),
        (wall("A"), "A moves towards B, which lies between it and the wall"),
        (format!("{}, {}", wall("B"), wall("A")), "at the third impact: A moves towards B"),
        (wall("B").replace(r#""e": "1""#, r#""e": "7/5""#), "is given as 7/5, which is above 1"),
    ];
    for (then, words) in table {
        let output = with_stdin(&["solve", "-"], format!("{first}{then}]}}").as_bytes());
        assert_eq!(code(&output), i32::from(!words.is_empty()), "{then}: {}", stderr(&output));
        assert!(stderr(&output).contains(words), "{then}: {}", stderr(&output));
    }
    let plane = r#"{"masses": {"A": "2", "B": "4"}, "before": {"A": ["9", "1"], "B": ["0", "0"]}, "line_of_centres": ["1", "0"],
        "e": "1/2", "then": ["#;
    let at_rest = plane.replace(r#"["9", "1"]"#, r#"["9", "0"]"#);
    for (first, then, words) in [
        (plane, c(r#""B", "C""#, r#""-3""#), "a velocity along a line among others in a plane"),
        (&at_rest, wall("A"), "at the second impact: the sphere is at rest before, so it does not strike the wall"),
        (&at_rest, wall("B").replace(r#"["0", "1"]"#, r#"["1", "0"]"#), "the sphere moves parallel to the wall"),
    ] {
        let output = with_stdin(&["solve", "-"], format!("{first}{then}]}}").as_bytes());
        assert!(code(&output) == 1 && stderr(&output).contains(words), "{then}: {}", stderr(&output));
    }
}

#[test]
fn what_a_scene_asks_beyond_what_there_is_is_said_as_it_is() {
    let scene =
        |rest: &str| format!(r#"{{"masses": {{"A": "3", "B": "2"}}, "before": {{"A": "4", "B": "0"}}, {rest}}}"#);
    let found = |rest: &str| scene(&format!(r#""e": "e", "symbols": {{"e": "unit"}}, "unknowns": ["e"], {rest}"#));
    let table = [
        (scene(r#""e": "3/2""#), "is given as 3/2, which is above 1"),
        (scene(r#""e": "-1/2""#), "is given as −1/2, which is negative"),
        (found(r#""conditions": ["A.after.n = 2"], "maximise": "ke.lost""#), "two ways to find an unknown"),
        (found(r#""conditions": ["second.B.after.n = 2"]"#), "of an impact that the scene does not have: there is one"),
        (
            r#"{"masses": {"A": "2"}, "before": {"A": ["3", "-1"]}, "wall": ["1", "0"]}"#.to_owned(),
            "the velocity before and e",
        ),
        (scene(r#""e": "cos(7/3 deg)""#), "as in `(7/3) deg`"),
    ];
    for (scene, words) in table {
        let output = with_stdin(&["solve", "-"], scene.as_bytes());
        assert!(code(&output) == 1 && stderr(&output).contains(words), "{scene}: {}", stderr(&output));
    }
    // e = 0 is one of its values, and no remark forbids it.
    let scene = r#"{"masses": {"A": "1", "B": "1"}, "before": {"A": "u", "B": "0"}, "e": "e", "unknowns": ["e"],
        "symbols": {"e": "unit", "u": "positive", "k": "positive"}, "conditions": ["A.after.n = k"]}"#;
    let output = with_stdin(&["solve", "-"], scene.as_bytes());
    let said = format!("{}{}", stdout(&output), stderr(&output));
    assert!(said.contains("(u − 2k)/u ≥ 0") && !said.contains("(u − 2k)/u > 0"), "{said}");
}

#[test]
fn a_fault_in_a_scene_is_under_its_caret() {
    let output = with_stdin(&["solve", "-"], b"{\n  \"e\": \"1/2 + q\"\n}");
    assert!(stderr(&output).contains("stdin:2:15"), "{}", stderr(&output));
    let output = with_stdin(&["solve", "-"], b"e = '1/2 + q'\n");
    assert!(stderr(&output).contains("stdin:1:12"), "{}", stderr(&output));
}

#[test]
fn what_a_scene_names_exists_and_is_not_given_already() {
    let scene = r#"{"masses": {"A": "3", "B": "2"}, "before": {"A": ["6", "1"], "B": ["0", "0"]},
        "line_of_centres": ["1", "0"], "sense": "A_to_B", "e": "1/2", "unknowns": ["e"], "conditions": ["A.after.m = 0"]}"#;
    let misspelt = scene.replace("A.after.m", "A.after.sped");
    for (scene, place, words) in [
        ("null", "1:1", "expected `{` and the fields of a scene"),
        ("[]", "1:1", "expected `{` and the fields of a scene"),
        ("[1,", "1:3", "this is no JSON"),
        (scene, "2:84", "`e` is given, and cannot be found"),
        (scene, "2:106", "unknown name `A.after.m`"),
        (&misspelt, "2:106", "did you mean `A.after.speed`?"),
    ] {
        let folder = folder("names");
        fs::write(folder.join("scene.json"), scene).unwrap();
        let output = carom(&["solve", folder.join("scene.json").to_str().unwrap()]);
        let said = stderr(&output);
        assert!(code(&output) == 1 && said.contains(&format!("scene.json:{place}")) && said.contains(words), "{said}");
    }
}

#[test]
fn what_a_scene_leaves_no_place_for_is_a_fault_at_its_own_field() {
    let wall = r#"{"before": {"A": ["3", "-4"]}, "wall": ["1", "0"], "e": "1/2", MORE}"#;
    let direct = r#"{"masses": {"A": "1", "B": "2"}, "before": {"A": "3", "B": "0"}, "e": "1/2", MORE}"#;
    let impulse = r#"{"masses": {"A": "1"}, "before": {"A": ["3", "-4"]}, "impulse": ["1", "0"], MORE}"#;
    let sense = r#""sense": "A_to_B""#;
    let radii = r#""radii": {"A": "1", "B": "1"}"#;
    for (scene, more, words) in [
        (wall, sense, "it is given beside a `wall`"),
        (wall, radii, "it is given beside a `wall`"),
        (direct, sense, "it is given beside velocities along one line"),
        (direct, radii, "it is given beside velocities along one line"),
        (impulse, sense, "it is given beside an `impulse`"),
        (impulse, radii, "it is given beside an `impulse`"),
        (wall, r#""after": {"B": ["1", "0"]}"#, "there is no sphere B"),
    ] {
        let text = scene.replace("MORE", more);
        let output = with_stdin(&["solve", "-"], text.as_bytes());
        assert_eq!(code(&output), 1, "{text}");
        let said = stderr(&output);
        assert!(said.contains(words), "{said}");
        // The caret stands below what is given there, and not below another field.
        let value = text.find(more).unwrap() + more.find(": ").unwrap();
        let column = said.split("stdin:1:").nth(1).unwrap().split_whitespace().next().unwrap();
        assert!(column.parse::<usize>().unwrap() > value, "{said}");
    }
}

#[test]
fn a_bank_of_ones_own_is_listed_explained_and_checked() {
    let folder = folder("bank");
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("question_bank/rest-letters");
    fs::create_dir_all(folder.join("own")).unwrap();
    let text = fs::read_to_string(shipped.join("direction-and-deflection.toml")).unwrap();
    fs::write(folder.join("own/deflection.toml"), &text).unwrap();
    let bank = folder.to_str().unwrap();

    let output = carom(&["list", "--bank", bank, "--json"]);
    let list: Json = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!(list["questions"][0]["id"], "own/deflection");
    assert!(list["questions"][0]["styles"][0]["variants"].as_u64().unwrap() > 60);
    // What nobody has examined is not counted unasked.
    let list = stdout(&carom(&["list", "--bank", bank]));
    assert!(list.contains("1 question") && list.contains("  friendly") && list.contains("--count"), "{list}");
    let list = stdout(&carom(&["list", "--bank", bank, "--count"]));
    assert!(list.contains(" friendly") && !list.contains("  friendly") && !list.contains("--count"), "{list}");

    let output = carom(&["explain", "deflection", "--bank", bank]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    for words in ["Style friendly", "requires", "Steps", "Marks", "Slips", "An example", "restitution-reversed"] {
        assert!(stdout(&output).contains(words), "{words}: {}", stdout(&output));
    }

    let output = carom(&["check", bank]);
    assert_eq!(code(&output), 0, "{}", stderr(&output));
    assert!(stdout(&output).contains("0 findings"), "{}", stdout(&output));
    // No bar is drawn in a pipe.
    assert!(stderr(&output).is_empty(), "{}", stderr(&output));

    fs::write(folder.join("own/broken.toml"), text.replacen("code = \"B1\"", "code = \"B9\"", 1)).unwrap();
    let output = carom(&["check", bank]);
    assert_eq!(code(&output), 1);
    assert!(stderr(&output).contains("unknown mark code `B9`"), "{}", stderr(&output));
    let output = carom(&["check", bank, "--json"]);
    assert_eq!(code(&output), 1);
    let report: Json = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!(report["faults"].as_array().unwrap().len(), 1);
    // A sheet of the sound question alone does not mind the broken one.
    assert_eq!(code(&sheet(&folder.join("sheet"), &["own/deflection", "--bank", bank])), 0);
    assert_eq!(code(&sheet(&folder.join("sheet"), &["own/broken", "--bank", bank])), 1);
}

#[test]
fn a_sheet_from_a_bank_of_ones_own_says_what_check_calls_an_error() {
    let folder = folder("amiss");
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("question_bank/rest/speeds-and-directions.toml");
    let text = fs::read_to_string(shipped).unwrap();
    let bank = folder.join("my bank");
    fs::create_dir_all(&bank).unwrap();
    fs::write(bank.join("sound.toml"), &text).unwrap();
    fs::write(bank.join("wrong.toml"), text.replacen("{mA kg}", "{mB kg}", 1)).unwrap();
    fs::write(folder.join("class.csv"), "student\n1\n2\n").unwrap();
    let (bank, class) = (bank.display().to_string(), folder.join("class.csv").display().to_string());
    for more in [&["--seed", "3"][..], &["--class", &class], &["--reference"]] {
        let sheet = |question| {
            let out = folder.join("sheet");
            let output = sheet(&out, &[&[question, "--bank", &bank], more].concat());
            fs::remove_dir_all(out).unwrap();
            output
        };
        let output = sheet("wrong");
        let said = stderr(&output);
        assert_eq!(code(&output), 0, "{said}");
        assert!(said.starts_with("error: `wrong`: the words"), "{said}");
        assert!(said.contains(&format!("`carom check \"{bank}\"` says where")), "{said}");
        let output = sheet("sound");
        assert!(!stderr(&output).contains("error"), "{}", stderr(&output));
    }
}

#[test]
fn usage_is_two_and_help_is_nought() {
    for (arguments, expected) in [
        (&["--help"][..], 0),
        (&["--version"], 0),
        (&["sheet", "--help"], 0),
        (&["solve", "--help"], 0),
        (&["list", "--help"], 0),
        (&["explain", "--help"], 0),
        (&["check", "--help"], 0),
        (&[], 2),
        (&["paint"], 2),
        (&["solve"], 2),
        (&["explain"], 2),
        (&["sheet", "--seed", "-1"], 2),
    ] {
        let output = carom(arguments);
        assert_eq!(code(&output), expected, "{arguments:?}: {}", stderr(&output));
        if expected == 0 && arguments.len() == 2 {
            assert!(stdout(&output).contains("Example"), "{arguments:?}");
        }
    }
    for (arguments, expected) in [
        (["--count", "-3"], "invalid value '-3' for '--count <N>': expected a whole number from 1 to 1000"),
        (["--count", "0"], "from 1 to 1000"),
        (["--count", "1e3"], "from 1 to 1000"),
        (["--count", "99999999999999999999"], "from 1 to 1000"),
        (["--marks", "1.5"], "expected a whole number from 1 to 2000"),
        (["--seed", "-1"], "expected a whole number from 0 to 18446744073709551615"),
        (["--seed", "today"], "such as 2027"),
    ] {
        let output = carom(&[&["sheet"][..], &arguments].concat());
        assert!(code(&output) == 2 && stderr(&output).contains(expected), "{arguments:?}: {}", stderr(&output));
    }
    assert_eq!(code(&carom(&["explain", "5C-99"])), 1);
    assert_eq!(code(&carom(&["check", "no/such/bank"])), 1);
}

#[cfg(unix)]
#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["solve", "-", "--json"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!((code(&output), stderr(&output)), (0, String::new()));
}

#[test]
fn help_is_a_command_too_and_colours_can_be_refused_before_any_command() {
    let (help, flag) = (carom(&["help", "sheet"]), carom(&["sheet", "--help"]));
    assert_eq!((code(&help), stdout(&help)), (0, stdout(&flag)));
    assert_eq!(stdout(&carom(&["help"])), stdout(&carom(&["--help"])));
    assert_eq!(code(&carom(&["help", "shete"])), 2);
    for arguments in
        [&["--color", "never", "shete"][..], &["shete", "--colour=never"], &["sheet", "--help", "--color", "never"]]
    {
        let said = carom(arguments);
        assert!(!format!("{}{}", stdout(&said), stderr(&said)).contains('\u{1b}'), "{arguments:?}");
    }
    let said = carom(&["--color", "always", "shete"]);
    assert!(stderr(&said).contains('\u{1b}'), "{}", stderr(&said));
}

#[test]
fn explain_has_the_whole_of_what_earns_a_mark() {
    let said = stdout(&carom(&["explain", "walls/wall-along-a-vector"]));
    assert!(
        said.contains("before the impact: ") && !said.contains(" and (needs") && !said.contains(" and\n"),
        "{said}"
    );
    let said = stdout(&carom(&["explain", "walls/wall-along-a-vector", "--json"]));
    assert!(!said.contains(" and\""), "{said}");
}
