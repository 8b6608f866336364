//! `carom check` finds what it is there to find: each kind of fault is planted in a copy of a shipped question, by an edit
//! of its text, and must be named.

use std::path::PathBuf;
use std::process::Command;
use std::{env, fs};

/// Fewer numbers for questions that have many, so that a fault is found sooner.
const FEWER: [(&str, (&str, &str)); 4] = [
    ("direct/one-sphere-catches-the-other", ("u  = \"4..12\"", "u  = [\"4\", \"9\"]")),
    ("rest/speeds-and-directions", ("alpha = \"15..75\"", "alpha = \"15..75 step 10\"")),
    ("rest/speeds-and-directions", ("u     = \"2..8\"", "u     = \"2..8 step 2\"")),
    ("both-moving/paths-at-right-angles", ("b     = \"3..7\"", "b     = \"3..7 step 2\"")),
];

/// A name for the fault, the edits that plant it, and the words that must name it.
type Planted<'t> = (&'t str, &'t [(&'t str, &'t str)], &'t str);

/// What `carom check` says of a shipped question after edits, all of which must apply, and whether it is content.
fn checked(name: &str, id: &str, edits: &[(&str, &str)]) -> (bool, String) {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let mut text = fs::read_to_string(root.join(format!("question_bank/{id}.toml"))).expect(id);
    for (from, to) in edits.iter().chain(FEWER.iter().filter(|(of, ..)| *of == id).map(|(_, edit)| edit)) {
        assert!(text.contains(from), "{name}: `{from}` no longer stands in {id}");
        text = text.replace(from, to);
    }
    let folder = env::temp_dir().join(format!("carom-mutations-{}-{name}", std::process::id()));
    fs::create_dir_all(folder.join("bank")).expect("a folder can be made");
    fs::write(folder.join("bank/question.toml"), text).expect("a file can be written");
    let output = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["check", "bank"])
        .current_dir(&folder)
        .env("XDG_CACHE_HOME", folder.join("cache"))
        .output()
        .expect("carom runs");
    let said = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    fs::remove_dir_all(&folder).expect("the folder is there");
    (output.status.success(), said)
}

/// Each fault alone is found, and named in these words.
fn found(id: &str, table: &[Planted]) {
    for (name, edits, words) in table {
        let (is_sound, said) = checked(name, id, edits);
        assert!(said.contains(words), "{name}: no `{words}` in\n{said}");
        let is_warning = said.contains("warning:") && !said.contains("error:");
        assert!(!is_sound || is_warning, "{name} is named, and carom is content:\n{said}");
    }
}

#[test]
fn unedited_questions_are_sound() {
    for id in ["rest-letters/direction-and-deflection", "both-moving/paths-at-right-angles"] {
        let (is_sound, said) = checked(&format!("sound-{}", id.len()), id, &[]);
        assert!(is_sound && said.contains("0 findings"), "{id}: {said}");
    }
}

#[test]
fn faults_of_the_numbers_are_named() {
    found(
        "rest-letters/turned-through-a-right-angle",
        &[
            (
                "impossible",
                &[("  \"q > p\",\n", ""), ("\"restitution*q > p\", ", "")],
                "are turned away by no requirement and cannot happen",
            ),
            ("no-variant", &[("\"q > p\"", "\"q > 100*p\"")], "mend `q > 100*p`, or take it out: it turns away all"),
            ("no-need", &[("\"q > p\"", "\"q > p\", \"q > 0\"")], "`q > 0` turns no set of numbers away"),
            (
                "restitution",
                &[("\"1/2\", \"2/3\", \"3/4\"", "\"1/2\", \"4/3\", \"3/4\"")],
                "`restitution` may be 4/3, and a coefficient of restitution is from 0 to 1",
            ),
            (
                "too-many",
                &[
                    ("\"1..5\"", "\"1..50000\""),
                    ("\"2..8\"", "\"2..50000\""),
                    ("\"q > p\"", "\"q < 0\""),
                    ("\"denominator(p/q) = q\"", "\"p < 0\""),
                ],
                "too many to examine",
            ),
        ],
    );
    found(
        "rest/speeds-and-directions",
        &[
            (
                "promise",
                &[("alpha = [\"30\", \"60\"]", "alpha = [\"30\", \"50\"]")],
                "the answer `A.after.speed` has no short exact form",
            ),
            (
                "tie",
                &[("u     = \"4\"\n", "u     = \"9\"\n")],
                "`A.after.speed` of the reference is too near a tie to be rounded",
            ),
            (
                "one-value",
                &[("  \"abs(A.after.speed - B.after.speed) > B.after.speed/50\",\n", "")],
                "`A.after.speed` and `B.after.speed` have one value",
            ),
            (
                "one-value-mended",
                &[("  \"abs(A.after.speed - B.after.speed) > B.after.speed/50\",\n", "")],
                "require `abs(A.after.speed - B.after.speed) > abs(B.after.speed)/50`",
            ),
        ],
    );
}

#[test]
fn slips_that_cannot_show_are_named_and_so_is_what_is_declared_without_need() {
    found(
        "rest/speeds-and-directions",
        &[
            (
                "sine-for-cosine",
                &[("alpha = [\"30\", \"60\"]", "alpha = [\"45\", \"60\"]")],
                "add `\"abs(A.before.n) != abs(A.before.t)\"` to `require`, which leaves",
            ),
            (
                "equal-masses",
                &[("  \"mA != mB\",\n", "")],
                "the slips `masses-swapped`, `masses-omitted` do not show in some variants, first with mA = 1, mB = 1",
            ),
            (
                "another-list",
                &[
                    ("  \"mA != mB\",\n", ""),
                    (
                        "[parameters]\n",
                        "hidden = [\"sincos-swap\", \"masses-swapped\", \"coalesce\"]\n\n[parameters]\n",
                    ),
                ],
                "add `\"A.mass != B.mass\"` to `require`, which leaves",
            ),
            (
                "needless",
                &[("[parameters]\n", "hidden = [\"sincos-swap\"]\n\n[parameters]\n")],
                "the slip `sincos-swap` is declared hidden, and shows in every variant",
            ),
            (
                "not-alike",
                &[("[parameters]\n", "alike = [\"speed-sum = speed-no-root\"]\n\n[parameters]\n")],
                "the slips `speed-sum` and `speed-no-root` are declared alike",
            ),
            (
                "unknown-slip",
                &[("[parameters]\n", "hidden = [\"sincos-swop\"]\n\n[parameters]\n")],
                "unknown slip `sincos-swop`",
            ),
        ],
    );
    found(
        "both-moving/paths-at-right-angles",
        &[(
            "alike",
            &[("\"approach-subtracted = restitution-reversed\"", "\"speed-sum = speed-no-root\"")],
            "the slips `approach-subtracted` and `restitution-reversed` come to the same in every variant",
        )],
    );
}

#[test]
fn texts_that_read_badly_are_named() {
    let id = "rest-letters/direction-and-deflection";
    found(
        id,
        &[
            ("unreduced", &[("\"1/2\", \"2/3\"", "\"2/4\", \"2/3\"")], "not in its lowest terms: `2/4`"),
            ("twice", &[("of mass {mB}, which", "of masses {mB} and {mB}, which")], "the same thing said twice"),
            ("article-twice", &[("is moving", "is a a moving")], "a word said twice: `a a`"),
            ("word-twice", &[("the spheres is {", "the the spheres is {")], "a word said twice: `the the`"),
            ("stray", &[("{restitution}.", "{restitution} .")], "a stray sign"),
            ("spelling", &[("the spheres is {", "the shperes is {")], "a slip of the pen: `shperes`"),
            ("full-stop", &[("line of centres.\n'''", "line of centres\n'''")], "a sentence without a full stop"),
            ("plural", &[("on the plane. The", "{q} times on the plane. The")], "one of several: `1 times`"),
            (
                "factor",
                &[
                    ("of mass {mB}, which", "of mass {k}, which"),
                    ("q           = \"1..6\"", "q           = \"1..6\"\nk           = [\"1*m\", \"2*m\"]"),
                    ("restitution = \"e\"\n", "restitution = \"e\"\nk           = \"2*m\"\n"),
                ],
                "a factor of one",
            ),
            (
                "unused",
                &[("delta = \"acute\"", "delta = \"acute\"\nw     = \"positive\"")],
                "nothing uses the letter `w`",
            ),
            ("emphasis", &[("the spheres is {", "the *spheres is {")], "a stray sign: `"),
            ("an", &[("the spheres is {", "an smooth sphere is {")], "`a` or `an` before a word: `an smooth`"),
            ("missing", &[("of mass {mA} is moving", "is moving"), ("of mass {mB}, which", "which")], "never give `p`"),
            ("obtuse", &[("makes an acute angle {beta}", "makes an obtuse angle {beta}")], "not so: `obtuse angle β`"),
            (
                "to-find",
                &[("ask = \"Show that {display: result}\"", "ask = \"Find {tan(beta)}. {display: result}\"")],
                "ask to find it",
            ),
            ("in-terms", &[("ask = \"Show that", "ask = \"Show, in terms of {v}, that")], "in terms of `v`"),
        ],
    );
    found(
        "both-moving/paths-at-right-angles",
        &[
            (
                "not-in-terms",
                &[
                    ("speed = [\"v\"]", "speed = [\"1\"]"),
                    ("\"denominator(A.after.n/v) <= 4\", ", ""),
                    ("\"denominator(A.after.n/v) <= 12\", ", ""),
                ],
                "in terms of `v` and does not have it",
            ),
            ("article", &[("masses {mA kg} and", "masses an {mA kg} and")], "`a` or `an` before a number"),
            (
                "away",
                &[
                    ("B = [\"-uB\", \"0\"]", "B = [\"uB\", \"0\"]"),
                    ("A = [\"0\", \"uA\"]", "A = [\"10*uB\", \"uA\"]"),
                    ("  \"q > e*p\",\n", ""),
                    ("\"denominator(A.after.n/v) <= 4\", ", ""),
                    ("\"denominator(A.after.n/v) <= 12\", ", ""),
                ],
                "a direction that is not so: `B moves towards A`",
            ),
        ],
    );
}

#[test]
fn a_stray_sign_is_shown_once_and_where_it_stands() {
    let edits = [("As a result of the collision", "As a *result of the collision")];
    let (_, said) = checked("at-its-line", "rest-letters/turned-through-a-right-angle", &edits);
    assert_eq!(said.matches("a stray sign").count(), 1, "{said}");
    let mut lines = said.lines().skip_while(|line| !line.contains("| spheres. As a *result of the"));
    assert!(lines.next().is_some() && lines.next().is_some_and(|line| line.contains("^ here")), "{said}");
}

#[test]
fn where_nothing_can_be_printed_nothing_is_said_of_slips() {
    // The question has a list `alike`, of which nothing can be said either.
    let edits = [("\"q > p\"", "\"q > 100*p\"")];
    let (is_sound, said) = checked("no-slips", "rest-letters/turned-through-a-right-angle", &edits);
    assert!(!is_sound && said.contains("has no variant") && !said.contains("alike"), "{said}");
}

#[test]
fn words_that_ask_for_exact_form_and_answers_that_must_be_exact_are_named_where_they_disagree() {
    let exact = "exact = [\"speed of *A*\", \"speed of *B*\"]\n";
    found(
        "rest/speeds-and-directions",
        &[
            (
                "asked-in-vain",
                &[(exact, "")],
                "style `exact` asks for exact form, and `speed of A` may be rounded there",
            ),
            (
                "never-asked",
                &[("note = \"Give the speeds in exact form and the", "note = \"Give the")],
                "the answer `A.after.speed` must be exact, and no words say so",
            ),
            (
                "never-asked-in-a-style",
                &[("note = \"Give the speeds in exact form and the", "note = \"Give the")],
                "or take the answer out of this list",
            ),
            (
                "pointed-at-in-the-style",
                &[("note = \"Give the speeds in exact form and the", "note = \"Give the"), ("exact = [", "exact=[")],
                "exact=[\"speed of *A*\", \"speed of *B*\"]\n   | ^^^^^",
            ),
        ],
    );
    found(
        "rest-letters/distance-from-the-centre-of-b",
        &[(
            "asked-in-a-part",
            &[("kind = \"number\", accept = \"exact\"", "kind = \"number\", accept = \"awrt 3sf\"")],
            "styles `friendly`, `exact` ask for exact form, and",
        )],
    );
    found(
        "successive/three-in-a-line",
        &[(
            "one-forgotten",
            &[("\"speed of *C*\", \"impulse on *C*\"]", "\"impulse on *C*\"]")],
            "style `exact` asks for exact form, and `speed of C` may be rounded there",
        )],
    );
}

#[test]
fn a_number_that_is_never_said_is_named_at_its_key() {
    let edits = [
        ("The coefficient of restitution between the spheres is {e}.", "The spheres do not stick together."),
        ("*A*, of mass {mA kg}, is", "*A* is"),
        ("the speed of *A* is {u m/s} and", "*A* is fast and"),
    ];
    let (is_sound, said) = checked("unsaid", "rest/speeds-and-directions", &edits);
    assert!(!is_sound, "{said}");
    // Of style friendly: `e` and `mA` stand among the parameters of all styles, `u` among its own.
    for (key, help) in
        [("e  = [\"1/4\"", "`{e}`"), ("mA = \"1..6\"", "`{mA kg}`"), ("u     = [\"5\", \"10\"", "`{u m/s}`")]
    {
        let name = key.split(' ').next().unwrap();
        let message = format!("the words of style `friendly` never give `{name}`");
        let picture =
            said.split("error:").find(|picture| picture.contains(&message)).unwrap_or_else(|| panic!("{said}"));
        let mut lines = picture.lines().skip_while(|line| !line.contains(&format!("| {key}")));
        assert!(lines.next().is_some(), "{picture}");
        let carets = format!("| {} the scene takes it", "^".repeat(name.len()));
        assert!(lines.next().is_some_and(|line| line.contains(&carets)), "{picture}");
        assert!(picture.contains(&format!("write it into the stem, as in {help}")), "{picture}");
    }
}

#[test]
fn tests_of_the_author_that_fail_and_marks_that_measure_nothing_are_named() {
    found(
        "rest-letters/direction-and-deflection",
        &[(
            "idle",
            &[("  { code = \"B1\", for = \"perpendicular\" },\n", "  { code = \"B1\", for = \"impulse\" },\n")],
            "is never won, not even by the model solution",
        )],
    );
    found(
        "rest/speeds-and-directions",
        &[
            (
                "test",
                &[("\"A.after.speed\" = \"4*sqrt(39)/9\"", "\"A.after.speed\" = \"2.87\"")],
                "test 1 fails: `A.after.speed` is `2.87` in it, and comes to `4√39/9 ≈ 2.7756`",
            ),
            ("mirrors", &[("mirrors = \"5C-2\"", "mirrors = \"5C-99\"")], "there is no exercise `5C-99`"),
            ("test-numbers", &[("[[test]]\n", "[[test]]\nnumbers = { e = \"0\" }\n")], "test 1 fails: "),
            ("test-name", &[("\"A.after.speed\" = \"4", "\"A.after.sped\" = \"4")], "`A.after.sped` is not asked for"),
            (
                "no-step",
                &[("code = \"dM1\", for = \"solve\"", "code = \"dM1\", for = \"deflection\"")],
                "a step that no answer",
            ),
        ],
    );
}

#[test]
fn numbers_said_in_the_wrong_unit_and_formulas_without_a_value_are_named() {
    found(
        "rest/speeds-and-directions",
        &[
            ("unit", &[("{mA kg}", "{mA m/s}")], "`mA` is said in m/s, and the scene takes it in kg"),
            ("no-unit", &[("{alpha deg}", "{alpha}")], "the angle `alpha` is said without a unit"),
            (
                "few-figures",
                &[("to 3 significant figures", "to 2 significant figures")],
                "asks for `2sf`, and the rule of",
            ),
            (
                "no-speed",
                &[("the speed of *A* is {u m/s} and", "the speed of *A* is {u} and")],
                "`u` is said without a unit",
            ),
            ("beside", &[("{u m/s}", "{u}m/s")], "the unit `m/s` stands beside the braces of `u`"),
            ("unit-twice", &[("{u m/s}", "{u m/s} m/s")], "the unit `m/s` stands beside the braces of `u`"),
            ("nought", &[("{u m/s}", "{u/(mA-mA) m/s}")], "a division by nought"),
        ],
    );
}

#[test]
fn words_that_the_scene_contradicts_are_named() {
    found(
        "direct/one-sphere-catches-the-other",
        &[
            ("at-rest", &[("They are moving", "They are at rest, or moving")], "a motion that is not so: `at rest`"),
            ("b-at-rest", &[("The speed of *A* is", "*B* is at rest. The speed of *A* is")], "not so: `B is at rest`"),
            (
                "moving",
                &[("B = \"w\"", "B = \"0*w\""), ("The speed of *A* is", "*B* is moving. The speed of *A* is")],
                "`B is moving`",
            ),
            ("nobody", &[("between them is", "between *A* and *C* is")], "the words speak of `*C*`"),
            ("no-stars", &[("speed of *B* is", "speed of B is")], "the name of a sphere without its stars: `B`"),
            ("article", &[("speed of *A* is", "speed of A is")], "the name of a sphere without its stars: `A`"),
            (
                "in-words",
                &[("lost in the collision.", "lost in the collision. (3 marks)")],
                "marks in words: `(3 marks)`",
            ),
            ("named", &[("\"kinetic energy lost\"", "\"speed of *A*\"")], "the answer `speed of A` is stated in J"),
            ("asked", &[("Find the total kinetic energy lost", "Find the speed of *A*")], "what is stated in m/s"),
            ("shown", &[("Find the total kinetic", "Show that the total kinetic")], "no answer is of kind `shown`"),
            (
                "speeds-exchanged",
                &[("*A* is {u m/s} and the speed of *B* is {w m/s}", "*A* is {w m/s} and the speed of *B* is {u m/s}")],
                "the words give `*A*` the speed `w`",
            ),
            (
                "masses-bare",
                &[("masses {mA kg} and {mB kg} respectively", "masses {mA} and {mB} respectively")],
                "`mB` is said without a unit",
            ),
            (
                "heavier",
                &[("collide directly.", "collide directly. Sphere *A* is heavier than *B*.")],
                "a comparison that is not so: `A is heavier than B`",
            ),
            ("rough", &[("smooth horizontal floor", "rough horizontal floor")], "the words say `rough`"),
            ("vector", &[("them is {e}", "them is {i*e}")], "the words have a vector"),
            (
                "of-another",
                &[("Find the speed of *B*", "Find the speed of *A*")],
                "the words ask of `*A*`, and the answer `speed of B` is of *B*",
            ),
            ("one-of-two", &[("Two smooth spheres", "Two smooth sphere")], "several of one: `Two … sphere`"),
            ("ahead", &[("*A* behind *B*", "*B* behind *A*")], "a direction that is not so: `B is behind A`"),
            ("no-wall", &[("after the collision.\"", "after it leaves the wall.\"")], "the words speak of a wall"),
            ("figure", &[("collide directly.", "collide directly, as in Figure 2.")], "speak of a figure by number"),
            (
                "digits",
                &[("[reference]", "[[test]]\nanswers = { \"ke.lost\" = \"7.499\" }\n\n[reference]")],
                "`7.499` in it",
            ),
        ],
    );
}

#[test]
fn what_is_asked_for_and_found_elsewhere_is_named() {
    found(
        "successive/corner",
        &[(
            "wall-before",
            &[("find = [\"second.A.after.x\", \"second.A.after.y\"]", "find = [\"A.after.x\", \"A.after.y\"]")],
            "find `second.A.after.x` and `second.A.after.y`, or ask for what is before the impact",
        )],
    );
    found(
        "direct/velocities-in-letters",
        &[(
            "too-few-letters",
            &[("in terms of {m}, {u} and {e}, the kinetic", "in terms of {m} and {u}, the kinetic")],
            "the answer `ke.lost` has the letter `e`, and is asked for in terms of `m`, `u`",
        )],
    );
    found(
        "walls/rebound-speed-and-direction",
        &[(
            "one-sphere",
            &[("between *A* and the wall is", "between the spheres is")],
            "speak of spheres, and the scene has one",
        )],
    );
}

#[test]
fn a_letter_is_of_one_angle_at_one_time() {
    found(
        "walls/restitution-from-two-angles",
        &[
            ("sine", &[("{tan(beta) = after}", "{sin(beta) = after}")], "give `*A*` the angle `beta`"),
            (
                "one-letter",
                &[("angle {beta} with", "angle {alpha} with")],
                "call the angle after the impact `alpha`, and `alpha` is the angle before the impact",
            ),
        ],
    );
    found(
        "rest-letters/direction-and-deflection",
        &[
            (
                "it-before",
                &[("Immediately after the collision it makes", "Immediately before the collision it makes")],
                "call the angle before the impact `beta`, and `beta` is the angle after the impact",
            ),
            (
                "a-after",
                &[("Immediately before the collision the direction", "Immediately after the collision the direction")],
                "call the angle after the impact `alpha`, and `alpha` is the angle before the impact",
            ),
            ("unknown", &[("angle {delta}", "angle {alpha}")], "the words never say what `delta` is"),
        ],
    );
    found(
        "successive/tangents-at-two-walls",
        &[("second-wall", &[("angle {gamma} to", "angle {beta} to")], "after the second impact `beta`")],
    );
}

#[test]
fn who_moves_towards_a_wall_and_who_turns_back_is_so_in_the_scene() {
    let letters = "walls/tangents-in-letters";
    found(
        letters,
        &[
            (
                "away-from-wall",
                &[("plane towards a smooth", "plane away from a smooth")],
                "`*A*` moves away from the wall at first, and it is not so",
            ),
            (
                "towards-wall",
                &[(
                    "Immediately after the impact it is",
                    "Immediately after the impact *A* is moving towards the wall and is",
                )],
                "`*A*` moves towards the wall after the impact",
            ),
        ],
    );
    found(
        "successive/second-collision",
        &[(
            "away-from-far-wall",
            &[("{u m/s} along", "{u m/s} away from the wall along")],
            "away from the wall at first",
        )],
    );
    found(
        "direct/mass-from-the-velocities",
        &[
            (
                "old-one",
                &[("in the direction opposite to\nits old one", "in the direction of its old one")],
                "`*A*` then moves in its old direction, and it is not so",
            ),
            (
                "as-before",
                &[("in the direction opposite to\nits old one", "in the same direction as before")],
                "`*A*` then moves in its old direction, and it is not so",
            ),
        ],
    );
    found(
        "ranges/mass-ratio-that-can-be",
        &[(
            "back",
            &[("in the\nsame direction", "in the direction opposite to its original one")],
            "against its old direction",
        )],
    );
}

#[test]
fn numbers_that_were_typed_and_letters_that_are_not_said_are_named() {
    found(
        "rest/speeds-and-directions",
        &[
            ("typed", &[("of mass {mA kg}", "of mass 2 kg")], "write `{mA kg}` in the place of `2 kg`"),
            ("typed-more", &[("on the plane. The", "on the plane, 3 kg of it. The")], "give `3 kg` in plain digits"),
        ],
    );
    found(
        "walls/restitution-from-two-angles",
        &[("no-braces", &[("of mass {m} is", "of mass m is")], "the words give `m` without braces")],
    );
    found(
        "successive/tangents-at-two-walls",
        &[("no-letter", &[(" at an acute angle {alpha} to the first wall", "")], "an answer has the letter `alpha`")],
    );
    found(
        "ranges/mass-ratio-that-can-be",
        &[("no-factor", &[("masses {k*m} and", "masses {k} and")], "`*A*` the mass `k` where the scene gives it")],
    );
    found(
        "vector-impulse/size-of-the-impulse",
        &[("parent", &[("{[k*f, k*g] N s}", "{[f, g] N s}")], "give the impulse `[f, g]`")],
    );
    found(
        "rest-letters/direction-and-deflection",
        &[("derived", &[("*A* of mass {mA}", "*A* of mass {m}")], "write it into the stem, as in `{mA}`")],
    );
}

#[test]
fn texts_of_marks_are_of_the_component_and_the_impact_of_the_mark() {
    found(
        "i-j/velocities-after-impact",
        &[(
            "i-for-j",
            &[("parallel to {i} unchanged", "parallel to {j} unchanged")],
            "the text of the mark B1a is of a component",
        )],
    );
    found(
        "successive/corner",
        &[
            (
                "energy",
                &[("loses at the second wall", "loses at the first wall")],
                "speak of the first impact, and the answer `kinetic energy lost` is of the second",
            ),
            (
                "name",
                &[("\"velocity after the second wall\", find", "\"velocity after the first wall\", find")],
                "`velocity after the first wall` is found after a later one",
            ),
            (
                "mark",
                &[("text = \"velocity after the second wall\"", "text = \"velocity after the first wall\"")],
                "the text of the mark A1a speaks of what is after an impact",
            ),
        ],
    );
    found(
        "successive/tangents-at-two-walls",
        &[("impulse", &[("impulse that the second wall", "impulse that the first wall")], "speak of the first impact")],
    );
}

#[test]
fn an_answer_for_which_nobody_asks_is_named() {
    let asked = "Find the value of {alpha} for which the deflection of *A* is greatest, and the greatest deflection.";
    found(
        "deflection/greatest-deflection",
        &[("second-answer", &[(asked, "Find the greatest deflection of *A*.")], "1 answer in deg, and the part has 2")],
    );
    found(
        "deflection/equal-masses",
        &[("small", &[("as large as possible", "as small as possible")], "the words say `as small as possible`")],
    );
}

#[test]
fn what_students_earn_is_told_with_their_numbers_and_what_to_try() {
    // B moves along the line of centres, and nobody works that out.
    let of_b = ("{ code = \"A1\", for = \"A.after.n\", text", "{ code = \"A1\", for = \"direction B\", text");
    let (_, said) = checked("no-direction", "rest/speeds-and-directions", &[of_b]);
    let words =
        "the mark A1c is not given for right answers in exact form: `4√39/9 | arctan(3√3/5) | 16√3/9 | 0`, with mA = ";
    assert!(said.contains(words), "no `{words}` in\n{said}");
    let edits = [("A.after.x < 0", "A.after.x > 0"), ("is reversed", "is not changed"), ("mA < mB", "mA = mB")];
    let (_, said) = checked("end", "ranges/direction-reversed", &edits);
    for words in
        ["full credit is given for the range with its ends counted otherwise", "with which the range ends elsewhere"]
    {
        assert!(said.contains(words), "no `{words}` in\n{said}");
    }
}

#[test]
fn parts_speak_of_parts_that_come_before_them() {
    found(
        "direct/restitution-from-one-speed",
        &[
            (
                "hence",
                &[("ask = \"Find the speed of *B*", "ask = \"Hence find the speed of *B*")],
                "`Hence` begins the first part",
            ),
            (
                "no-part",
                &[("ask = \"Find the coefficient", "ask = \"Using your answer to part (d), find the coefficient")],
                "the words speak of part (d), which does not come before",
            ),
        ],
    );
}

#[test]
fn requirements_that_exclude_each_other_are_named() {
    found(
        "ranges/direction-reversed",
        &[(
            "exclusive",
            &[("require = [\"mA < mB\"]", "require = [\"mA > 4\", \"mA < 3\"]")],
            "take out `mA > 4` or `mA < 3`, of which no set of numbers meets both",
        )],
    );
}

#[test]
fn a_requirement_that_is_wanted_is_named() {
    found(
        "walls/turned-through-a-right-angle",
        &[(
            "wanted",
            &[("alpha = \"48..70\"", "alpha = \"40..70 step 2\"")],
            "add `\"alpha >= 46\"` to `require`, which turns these away and no others",
        )],
    );
    found(
        "ranges/direction-reversed",
        &[("wanted-pair", &[("require = [\"mA < mB\"]", "require = []")], "add `\"mB > mA\"` to `require`")],
    );
}

#[test]
fn a_direction_that_is_reversed_and_an_angle_without_braces_are_so_in_the_scene() {
    found(
        "successive/struck-onto-a-wall",
        &[(
            "reversed",
            &[(".\n'''", ". The direction of motion of *A* is reversed by the first collision.\n'''")],
            "the direction of `*A*` is reversed, and it is not so",
        )],
    );
    found(
        "walls/turned-through-a-right-angle",
        &[("by-hand", &[("through a right angle", "through 80°")], "`*A*` is turned through 80°")],
    );
}

#[test]
fn what_spheres_have_alike_and_how_they_lie_is_so_in_the_scene() {
    found(
        "i-j/energy-lost",
        &[
            (
                "equal-masses",
                &[("They are moving", "Their masses are equal. They are moving")],
                "the words say that masses are equal, and those of `*A*` and `*B*` are not",
            ),
            ("vector", &[("the velocity of *A* is", "the speed of *A* is")], "call the vector `[ax, ay]` a speed"),
        ],
    );
    found(
        "successive/three-in-a-line",
        &[("order", &[("in that order", "in the order *A*, *C*, *B*")], "the words put `*C*` between `*A*` and `*B*`")],
    );
}

#[test]
fn what_decides_and_is_never_told_is_named_and_any_words_that_tell_of_it_are_right() {
    let turn = "The impact turns\nthe direction of motion of *A* through a right angle.";
    let wall = "walls/turned-through-a-right-angle";
    found(
        wall,
        &[
            ("untold", &[(turn, "")], "the words never tell of the right angle"),
            ("another-turn", &[("through a right angle", "through {alpha deg}")], "`*A*` is turned through 60°"),
            ("degrees", &[("through a right angle", "through an angle of 45 degrees")], "is turned through 45°"),
        ],
    );
    for (name, words) in [
        ("across", "After the impact *A* moves at right angles to its original direction."),
        ("across-its-path", "After the impact the path of *A* is perpendicular to its old path."),
        ("ninety", "The impact turns the direction of motion of *A* through {90 deg}."),
    ] {
        let (is_sound, said) = checked(name, wall, &[(turn, words)]);
        assert!(is_sound && said.contains("0 findings"), "{words}: {said}");
    }
    found(
        "rest-letters/turned-through-a-right-angle",
        &[
            (
                "untold-in-letters",
                &[(
                    " As a result of the collision, the direction of motion of *A* is turned through a right angle.",
                    "",
                )],
                "the words never tell of the right angle",
            ),
            ("acute", &[("through a right angle", "through an acute angle")], "is turned through an acute angle"),
        ],
    );
    let sentence = "_[In this question_ {i} _and_ {j} _are perpendicular unit vectors in a horizontal plane.]_";
    found("i-j/energy-lost", &[("unit-vectors", &[(sentence, "")], "the words never tell what {i} and {j} are")]);
    let no_line: &[(&str, &str)] = &[(" with the line of centres", "")];
    let other_line: &[(&str, &str)] = &[("with the line of centres of", "with the tangent at the point of contact of")];
    found(
        "rest/speeds-and-directions",
        &[
            ("no-line", no_line, "from which line the angle `alpha` is measured"),
            ("other-line", other_line, "the words give `*A*` the angle `alpha`"),
        ],
    );
    let meeting = "After *B* has struck *C*, *A* does not strike *B* again. Find";
    let edits: &[(&str, &str)] = &[(meeting, "Find")];
    found("successive/no-more-collisions", &[("never-again", edits, "the words never tell of who meets again")]);
}

#[test]
fn what_makes_a_paper_wrong_is_an_error() {
    let energy = "Find the total kinetic energy lost in the collision.";
    let tables: [(&str, &[Planted]); 6] = [
        (
            "i-j/energy-lost",
            &[
                (
                    "of-one",
                    &[(energy, "Find the kinetic energy of *A* after the collision.")],
                    "the words ask for a kinetic energy, and the answer `kinetic energy lost` is what is lost",
                ),
                ("energy", &[(energy, "Find the kinetic energy.")], "the words ask for a kinetic energy"),
            ],
        ),
        (
            "direct/mass-from-the-velocities",
            &[(
                "other-mass",
                &[("the mass of *B*.\"", "the mass of *A*.\"")],
                "ask of `*A*`, and the answer `mass of B`",
            )],
        ),
        (
            "direct/one-sphere-catches-the-other",
            &[
                ("of-a", &[("Find the speed of *B*", "Find the speed of *A*")], "ask of `*A*`"),
                ("before", &[("*B* immediately after", "*B* immediately before")], "what is before an impact"),
                ("gained", &[("energy lost in", "energy gained in")], "what is `gained`"),
                ("unit", &[(energy, "Find the speed of *B* in the collision.")], "what is stated in m/s"),
                (
                    "mark-of-a",
                    &[("for = \"B.after.speed\" }", "for = \"B.after.speed\", text = \"speed of *A*\" }")],
                    "the mark A1c names `*A*`",
                ),
                (
                    "mark-of-law",
                    &[("for = \"momentum\" }", "for = \"momentum\", text = \"Newton's law of restitution\" }")],
                    "the text of the mark M1a speaks of restitution, and it is for `momentum`",
                ),
                ("p-and-q", &[("spheres *A* and *B*", "spheres *P* and *Q*")], "the words call a sphere `*P*`"),
            ],
        ),
        (
            "successive/struck-onto-a-wall",
            &[
                ("impulse", &[("the wall exerts on *B*", "*A* exerts on *B*")], "ask for an impulse of *A*"),
                ("wall-of-a", &[("between *B* and the wall", "between *A* and the wall")], "`*A*` and a wall, and in"),
                ("a-strikes", &[("collision *B* strikes", "collision *A* strikes")], "`*A*` strikes a wall"),
            ],
        ),
        (
            "deflection/greatest-deflection",
            &[("least", &[("greatest, and", "least, and")], "say `least`, and the scene makes")],
        ),
        (
            "walls/tangents-in-letters",
            &[
                (
                    "no-number",
                    &[("{display: result}", "{tan(beta) = alpha*tan(alpha)}.")],
                    "its right side is no number: `tan(beta)` is e tan α",
                ),
                ("twice-e", &[("{display: result}", "{tan(beta) = 2*restitution*tan(alpha)}.")], "and it is not so"),
            ],
        ),
    ];
    for (id, table) in tables {
        for (name, edits, words) in table {
            let (is_sound, said) = checked(name, id, edits);
            assert!(!is_sound && said.contains(words), "{name}: no error `{words}` in\n{said}");
        }
    }
    let edits = [(energy, "Find by how much the collision diminishes the total kinetic energy.")];
    let (is_sound, said) = checked("other-words-for-it", "i-j/energy-lost", &edits);
    assert!(is_sound && said.contains("warning: "), "{said}");
    let edits = [("{display: result}", "{tan(beta) = restitution*sin(alpha)/cos(alpha)}.")];
    let (is_sound, said) = checked("by-hand", "walls/tangents-in-letters", &edits);
    assert!(is_sound && said.contains("0 findings"), "{said}");
}

#[test]
fn names_that_are_exchanged_are_named() {
    found(
        "successive/no-more-collisions",
        &[("a-and-c", &[("between *B* and *C* is", "between *A* and *C* is")], "`*A*` and `*C*`, and in the scene")],
    );
    found(
        "rest/speeds-and-directions",
        &[("at-rest", &[("motion of *A* makes", "motion of *B* makes")], "the direction of `*B*`, which is at rest")],
    );
    found(
        "rest-letters/distance-from-the-centre-of-b",
        &[
            ("diameter", &[("radius {r}", "diameter {r}")], "give the diameter `r`, where the scene gives it 2r"),
            ("centre", &[("from the centre of *B*", "from the centre of *A*")], "from the centre of `*A*` to a line"),
        ],
    );
}

#[test]
fn a_question_that_stands_in_a_bank_twice_and_a_topic_with_a_slip_of_the_pen_are_named() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let folder = env::temp_dir().join(format!("carom-neighbours-{}", std::process::id()));
    fs::create_dir_all(folder.join("bank")).expect("a folder can be made");
    let wall = fs::read_to_string(root.join("question_bank/walls/velocity-in-i-and-j.toml")).expect("it is there");
    let other = fs::read_to_string(root.join("question_bank/walls/tangents-in-letters.toml")).expect("it is there");
    let again = wall.replace("title ", "title  ").replace("topic = \"walls\"", "topic = \"wells\"");
    assert_ne!(wall, again);
    for (name, text) in [("one", &wall), ("other", &other), ("twin", &again)] {
        fs::write(folder.join(format!("bank/{name}.toml")), text).expect("a file can be written");
    }
    let output = Command::new(env!("CARGO_BIN_EXE_carom"))
        .args(["check", "bank"])
        .current_dir(&folder)
        .env("XDG_CACHE_HOME", folder.join("cache"))
        .output()
        .expect("carom runs");
    fs::remove_dir_all(&folder).expect("the folder is there");
    let said = String::from_utf8_lossy(&output.stderr);
    for words in ["`one` and `twin` are one question", "only question on the topic `wells`", "help: write `walls`"] {
        assert!(said.contains(words), "no `{words}` in\n{said}");
    }
    assert!(output.status.success() && said.matches("warning:").count() == 2, "{said}");
}

#[test]
fn a_number_that_the_words_give_and_the_scene_does_not_take_is_named() {
    let edits: &[(&str, &str)] = &[("e      = \"e\"", "e      = \"1/2\"")];
    found("direct/one-sphere-catches-the-other", &[("untaken", edits, "nothing in the scene takes `e`")]);
}

#[test]
fn marks_that_are_paid_twice_or_not_at_all_are_named() {
    let last = "  { code = \"A1\", for = \"ke.lost\" },\n";
    found(
        "direct/one-sphere-catches-the-other",
        &[
            ("not-paid", &[(last, "")], "no accuracy mark is for the answer `kinetic energy lost`"),
            (
                "paid-before",
                &[(last, "  { code = \"A1\", for = \"B.after.speed\" },\n")],
                "for which part (a) has paid",
            ),
            (
                "used-twice",
                &[("  { code = \"dM1\"", "  { code = \"M1\", for = \"momentum\" },\n  { code = \"dM1\"")],
                "the marks M1a and M1c are both for `momentum`",
            ),
            (
                "paid-twice",
                &[(last, &[last, last].concat())],
                "the marks A1b and A1c are both for the value of `ke.lost`",
            ),
        ],
    );
}

#[test]
fn what_does_not_agree_with_what_stands_beside_it_is_named() {
    let speed = "{ code = \"A1\", for = \"A.after.speed\" }";
    found(
        "direct/velocities-after-impact",
        &[
            ("counted", &[("Two small smooth", "Three small smooth")], "three of which 2 are named"),
            ("one-of-several", &[("Two small smooth", "A small smooth")], "one of several: `A … spheres`"),
            ("verb", &[("are moving towards", "is moving towards")], "a verb of one for several"),
            (
                "text-of-another",
                &[(speed, "{ code = \"A1\", for = \"A.after.speed\", text = \"speed of *B*\" }")],
                "the text of the mark A1c names `*B*`",
            ),
            ("velocity", &[("Find the speed of each", "Find the velocity of each")], "is a speed alone"),
            ("coefficient", &[("the spheres is {e}", "the spheres is {e m/s}")], "has no unit"),
        ],
    );
    found(
        "successive/second-collision",
        &[
            (
                "denied",
                &[("*B* collides with *A* again", "*B* does not collide with *A* again")],
                "do not meet again, and with the conditions of the scene they meet",
            ),
            ("condition-turned", &[("second.B.after.n < A", "second.B.after.n > A")], "meet again, and with"),
        ],
    );
}

#[test]
fn a_requirement_that_would_turn_others_away_too_is_not_suggested() {
    let edits = [("  \"x*q + p*e*y > 0\",\n", "")];
    let (_, said) = checked("no-suggestion", "successive/walls-at-an-angle", &edits);
    assert!(said.contains("cannot happen") && !said.contains("`\"m > x\"`"), "{said}");
}

#[test]
fn a_name_without_a_value_is_named_at_its_formula() {
    let edits = [("\"mA != mB\", ", ""), ("/(mA + mB)", "/(mA - mB)")];
    let (_, said) = checked("no-value", "direct/one-sphere-catches-the-other", &edits);
    assert!(said.contains("`vA`, division by nought") && said.contains("^^ of no value there"), "{said}");
}

#[test]
fn what_every_student_loses_is_told_once_and_at_its_row() {
    let edits = [("{ code = \"A1\", for = \"ke.lost\" }", "{ code = \"A1\", for = \"A.ke_lost\" }")];
    let (_, said) = checked("once", "direct/one-sphere-catches-the-other", &edits);
    assert!(said.matches(" is not given for ").count() <= 2, "{said}");
}

#[test]
fn what_is_remembered_hides_no_fault() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let id = "rest-letters/direction-and-deflection";
    let sound = fs::read_to_string(root.join(format!("question_bank/{id}.toml"))).expect(id);
    let amiss = sound.replace("hidden = [\"rebound-missed\"]", "hidden = []");
    assert_ne!(sound, amiss, "{id} hides no slip any more");
    let folder = env::temp_dir().join(format!("carom-remembered-{}", std::process::id()));
    fs::create_dir_all(folder.join("bank")).expect("a folder can be made");
    let check = |text: &str, more: &[&str]| {
        fs::write(folder.join("bank/question.toml"), text).expect("a file can be written");
        let output = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(["check", "bank"])
            .args(more)
            .current_dir(&folder)
            .env("XDG_CACHE_HOME", folder.join("cache"))
            .output()
            .expect("carom runs");
        (output.status.success(), String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let entries = || fs::read_dir(folder.join("cache/carom/check")).map_or(0, Iterator::count);
    assert!(!check(&amiss, &[]).0);
    assert_eq!(entries(), 0, "nothing is remembered of a question with a finding");
    let (is_sound, first) = check(&sound, &[]);
    assert!(is_sound, "{first}");
    assert_eq!(entries(), 1);
    assert_eq!(check(&sound, &[]), (true, first.clone()), "what is remembered is printed alike");
    assert_eq!(check(&sound, &["--fresh"]), (true, first));
    assert!(!check(&amiss, &[]).0, "the fault is found again");
    // A folder that is none does no harm.
    fs::remove_dir_all(folder.join("cache")).expect("the folder is there");
    fs::write(folder.join("cache"), "no folder").expect("a file can be written");
    assert!(check(&sound, &[]).0);
    fs::remove_dir_all(&folder).expect("the folder is there");
}

#[test]
fn who_is_no_sphere_of_the_scene_cannot_be_asked_for() {
    let asked = "impulse exerted on *B* in";
    found(
        "both-moving/energy-lost-and-impulse",
        &[("stranger", &[(asked, "impulse exerted on *C* in")], "error: `question`: the words speak of `*C*`")],
    );
    found(
        "ranges/direction-reversed",
        &[(
            "number",
            &[("direction of motion of *A* is", "direction of motion of *e* is")],
            "the words speak of `e` as of a sphere, and it is a number",
        )],
    );
}

#[test]
fn whose_speed_is_asked_for_is_that_which_is_found() {
    found(
        "successive/sphere-wall-sphere",
        &[(
            "whose",
            &[(
                "speed of *A* immediately after it collides with *B*",
                "speed of *B* immediately after it collides with *A*",
            )],
            "the words ask of `*B*`, and the answer `speed of A after the second collision` is of *A*",
        )],
    );
}

#[test]
fn what_several_impacts_lose_is_not_what_one_does() {
    found(
        "successive/walls-at-an-angle",
        &[(
            "total",
            &[("kinetic energy that *A* loses at the second wall", "total kinetic energy lost in the two impacts")],
            "what several impacts lose",
        )],
    );
}

#[test]
fn units_beside_the_braces_and_units_of_something_else_are_named() {
    let (speed, impulse) = ("is {u m/s} and", "Find the magnitude of the impulse");
    found(
        "direct/velocities-after-impact",
        &[
            ("grams", &[("{mA kg} and", "{mA} grams and")], "`mA` is said in `grams`, and the scene takes it in kg"),
            ("per-hour", &[(speed, "is {u} kilometres per hour and")], "`u` is said in `kilometres per hour`"),
            ("in-words", &[(speed, "is {u} metres per second and")], "write `{u m/s}`"),
            ("in-joules", &[(impulse, "Find, in joules, the magnitude of the impulse")], "ask for it in `joules`"),
        ],
    );
    found(
        "rest/speeds-and-directions",
        &[
            (
                "radians",
                &[("[\"30\", \"60\"]", "[\"pi/6\", \"pi/3\"]")],
                "`alpha` is taken in degrees, and `pi/6` is in",
            ),
            ("no-deg", &[("\"atan(3/4)/deg\"", "\"atan(3/4)\"")], "write `atan(3/4)/deg`, or the number of degrees"),
        ],
    );
}

#[test]
fn what_is_asked_for_and_found_by_no_answer_is_named() {
    let asked = "Find the speed of *B* immediately after the collision.";
    found(
        "direct/one-sphere-catches-the-other",
        &[
            ("friction", &[(asked, "Find the coefficient of friction.")], "ask for `coefficient of friction`, and no"),
            (
                "ratio",
                &[(asked, "Find the ratio of the speeds of *A* and *B*.")],
                "ask for `ratio of the speeds`, and no",
            ),
            ("approach", &[(asked, "Find the speed of approach of the spheres.")], "ask for `speed of approach of`"),
            ("nothing", &[(asked, "What happens next?")], "the words name nothing that is to be found"),
            ("given", &[(asked, "Find the value of {e}.")], "the value of `e`, which the paper prints as a number"),
        ],
    );
    let impulse = "Find the magnitude of the impulse";
    found(
        "direct/velocities-after-impact",
        &[
            (
                "besides",
                &[(impulse, "State the direction of *A*, and find the magnitude of the impulse")],
                "`direction of *A*`",
            ),
            (
                "explained",
                &[(impulse, "Explain what happens, and find the magnitude of the impulse")],
                "say `explain`, and no",
            ),
        ],
    );
    found(
        "vector-impulse/impulse-from-two-velocities",
        &[(
            "magnitude",
            &[("Find, in terms of {i} and {j}, the impulse on", "Find the magnitude of the impulse on")],
            "ask for the magnitude of the impulse on *A*, and the answer is a vector",
        )],
    );
    found(
        "backwards/velocity-of-b-and-line-of-centres",
        &[(
            "tangent",
            &[("parallel to the line of centres of", "parallel to the common tangent of")],
            "a vector along the common tangent, and the answer is one along the line of centres",
        )],
    );
}

#[test]
fn impacts_that_the_words_count_otherwise_than_the_scene_are_named() {
    let second = "collides with *B* for the second time";
    found(
        "successive/sphere-wall-sphere",
        &[
            ("third-time", &[(second, "collides with *B* for the third time")], "is found before it"),
            ("first-time", &[(second, "collides with *B* for the first time")], "is found after a later one"),
            (
                "another-e",
                &[("of = [\"A\", \"B\"]\ne  = \"e\"", "of = [\"A\", \"B\"]\ne  = \"f\"")],
                "the words give the coefficient of restitution `e` where the scene gives it",
            ),
        ],
    );
    found(
        "successive/second-collision",
        &[
            (
                "none",
                &[("for which *B* collides with *A* again", "for which there is no second collision")],
                "do not meet again, and with the conditions of the scene they meet",
            ),
            ("equal-velocities", &[("n < A.after.n", "n <= A.after.n")], "do they where their velocities are equal"),
            (
                "letter",
                &[(" The coefficient of restitution between *B* and the wall is {f}.", "")],
                "the words print `f`, and never tell that it is a coefficient of restitution",
            ),
        ],
    );
    found(
        "ranges/direction-reversed",
        &[("closed", &[("A.after.x < 0", "A.after.x <= 0")], "the condition lets it come to rest")],
    );
    found(
        "ranges/mass-ratio-when-a-goes-on",
        &[("changed", &[("is not changed", "is changed")], "the direction of `*A*` is changed, and it is not so")],
    );
}

#[test]
fn ways_that_no_word_tells_are_named() {
    found(
        "direct/velocities-after-impact",
        &[("ways", &[("towards each other in opposite directions\n", "\n")], "which way the spheres move before")],
    );
    found(
        "both-moving/components-given",
        &[(
            "component-way",
            &[("along the line of centres, towards *A*, and", "along the line of centres, and")],
            "which way a component along the line of centres points",
        )],
    );
}

#[test]
fn words_of_marks_that_are_of_another_value_or_misspelt_are_named() {
    let lost = "{ code = \"A1\", for = \"ke.lost\" }";
    found(
        "direct/one-sphere-catches-the-other",
        &[
            (
                "another-thing",
                &[(lost, "{ code = \"A1\", for = \"ke.lost\", text = \"impulse on *B*\" }")],
                "the text of the mark A1b speaks of `impulse`, and it is for `ke.lost`",
            ),
            (
                "one-variant",
                &[(lost, "{ code = \"A1\", for = \"ke.lost\", note = \"accept 7.5 J only\" }")],
                "gives `7.5 J` in plain digits",
            ),
            (
                "other-figures",
                &[(lost, "{ code = \"A1\", for = \"ke.lost\", note = \"awrt 2sf\" }")],
                "is given for `2sf`, and the answer is accepted to `3sf`",
            ),
            (
                "energy-for-momentum",
                &[("\"M1\", for = \"momentum\"", "\"M1\", for = \"momentum\", text = \"conservation of energy\"")],
                "the text of the mark M1a speaks of energy, and it is for `momentum`",
            ),
            (
                "slip-in-a-title",
                &[("the kinetic energy lost\"\n", "the knetic energy lost\"\n")],
                "slip of the pen: `knetic`",
            ),
            (
                "slip-in-a-note",
                &[(lost, "{ code = \"A1\", for = \"ke.lost\", note = \"see the refrence\" }")],
                "a slip of the pen: `refrence`",
            ),
            (
                "no-wall",
                &[(
                    "\"M1\", for = \"restitution\"",
                    "\"M1\", for = \"restitution\", text = \"restitution at the wall\"",
                )],
                "speak of a wall, and the scene has none",
            ),
        ],
    );
    found(
        "rest/speeds-and-directions",
        &[(
            "nothing-to-follow",
            &[("\"A1\", for = \"momentum\"", "\"A1ft\", for = \"momentum\"")],
            "follows an earlier value, and none is found before it",
        )],
    );
}

#[test]
fn an_answer_with_a_letter_is_asked_for_in_no_unit() {
    found(
        "direct/mass-from-the-velocities",
        &[(
            "in-kilograms",
            &[("Find, in terms of {m}, the mass of *B*.", "Find the mass of *B*, in kilograms.")],
            "an answer with the letter `m` is asked for in `kilograms`",
        )],
    );
}

#[test]
fn letters_that_are_not_named_are_told_where_they_are_asked_for() {
    let edits = [("Find, in terms of {u} and {e}, the velocity", "Find, in terms of {u}, the velocity")];
    let (_, said) = checked("in-terms-place", "direct/velocities-in-letters", &edits);
    assert!(said.contains("| ask = \"Find, in terms of {u}, the"), "{said}");
}

#[test]
fn verbs_counts_and_articles_of_another_number_than_their_nouns_are_named() {
    found(
        "direct/velocities-after-impact",
        &[
            ("row", &[("spheres *A* and *B*", "spheres *A*, *B*")], "a row of names without `and`"),
            ("their", &[("are moving towards", "change its directions. They are moving towards")], "several … its"),
        ],
    );
    found(
        "direct/one-sphere-catches-the-other",
        &[
            ("masses", &[("have masses {mA kg}", "have mass {mA kg}")], "one of several: `mass … and …`"),
            (
                "collides",
                &[("The spheres\ncollide directly", "The spheres\ncollides directly")],
                "`several … collides`",
            ),
            (
                "walls",
                &[("horizontal floor", "horizontal floor, 3 wall of which are smooth")],
                "several of one: `3 wall`",
            ),
            ("each", &[("The speed of *A* is", "Each sphere have a mass. The speed of *A* is")], "`one … have`"),
            ("speed", &[("The speed of *A* is", "The speed of *A* are")], "a verb of several for one: `one … are`"),
            ("asked", &[("Find the total", "The spheres is smooth. Find the total")], "`several … is`"),
            (
                "in-a-mark",
                &[("\"A1\", for = \"ke.lost\"", "\"A1\", for = \"ke.lost\", note = \"these value must agree\"")],
                "several of one: `These value`",
            ),
        ],
    );
    found(
        "successive/three-in-a-line",
        &[
            ("order", &[("lie in that order", "lies in that order")], "a verb of one for several: `several … lies`"),
            ("strike", &[("then *B* strikes", "then *B* strike")], "a verb of several for one: `one … strike`"),
        ],
    );
    found(
        "rest/speeds-and-directions",
        &[("which-are", &[("which is at rest", "which are at rest")], "a verb of several for one: `one … are`")],
    );
}

#[test]
fn words_taken_for_others_small_letters_and_foreign_signs_are_named() {
    found(
        "direct/one-sphere-catches-the-other",
        &[
            ("small-letter", &[("ask = \"Find the total", "ask = \"find the total")], "a sentence without a capital"),
            ("tag", &[("horizontal floor", "<b>horizontal</b> floor")], "a sign of another language: `<b>`"),
            ("there", &[("between them is", "between there is")], "a slip of the pen: `there`"),
        ],
    );
}

#[test]
fn words_that_turn_the_scene_round_are_named() {
    found(
        "direct/one-sphere-catches-the-other",
        &[
            ("in-front", &[("*A* behind *B*", "*A* in front of *B*")], "`A is in front of B`"),
            (
                "slower",
                &[("The spheres\ncollide", "*A* is slower than *B*. The spheres\ncollide")],
                "A is slower than B",
            ),
        ],
    );
    let at_rest = "Spheres *B* and *C* are at rest.";
    found(
        "successive/three-in-a-line",
        &[(
            "all-rest",
            &[(at_rest, "Spheres *A*, *B* and *C* are at rest.")],
            "a motion that is not so: `A is at rest`",
        )],
    );
    let directly = "when it strikes *B* directly";
    found(
        "successive/second-collision",
        &[(
            "struck-by",
            &[(directly, "when it is struck by *B* directly")],
            "`*B*` strikes, and in the scene it is at",
        )],
    );
    found(
        "walls/rebound-speed-and-direction",
        &[("square", &[("it strikes a", "it strikes at right angles a")], "the wall is struck at right angles")],
    );
}

#[test]
fn a_letter_that_no_words_introduce_is_named() {
    let constant = ", where {k} is a positive constant";
    for id in ["vector-impulse/size-of-the-impulse", "ranges/mass-ratio-when-a-goes-on"] {
        found(id, &[("no-k", &[(constant, "")], "the words never say what `k` is")]);
    }
}

#[test]
fn what_may_be_meant_stops_nothing() {
    let signed = [
        ("towards each other in opposite directions\nalong the same", "along the same"),
        (
            "the speed of *A*\nis {u m/s} and the speed of *B* is {w m/s}.",
            "the velocity of *A* is {u m/s} and the velocity of *B* is {-w m/s}, where the direction of motion of *A* is taken as \
             positive.",
        ),
    ];
    let measured = [
        signed[0],
        (
            signed[1].0,
            "*A* has velocity {u m/s} and *B* has velocity {-w m/s}, both measured in the direction from *A* to *B*.",
        ),
    ];
    let named = [
        (
            "ask = \"Find the coefficient of restitution between the spheres.\"",
            "ask = \"The coefficient of restitution between the spheres is {e}. Find the value of {e}.\"",
        ),
        ("after  = { A = \"-v\" }", "after  = { A = \"-v\" }\nsymbols = { e = \"unit\" }"),
    ];
    for (name, id, edits, words) in [
        ("signed", "direct/velocities-after-impact", &signed[..], " 0 findings"),
        ("measured", "direct/velocities-after-impact", &measured, " 0 findings"),
        ("named-letter", "direct/restitution-from-one-speed", &named, " 0 findings"),
        (
            "equal-components",
            "both-moving/components-given",
            &[(
                "has component {a m/s} along the line of centres of the spheres,\ntowards *B*, and component {p m/s} \
                 perpendicular to the line of centres.",
                "has components {a m/s} and {p m/s} along the line of centres of the spheres,\ntowards *B*, and \
                 perpendicular to it.",
            )],
            "warning: `question`: a text that reads badly, the same thing said twice",
        ),
        (
            "one-value-of-components",
            "rest/components-of-each-velocity",
            &[("  \"abs(A.after.n - A.after.t) > A.after.t/100\",         # so that no answer\n", "")],
            "warning: `question`: `A.after.n` and `A.after.t` have one value",
        ),
    ] {
        let (is_sound, said) = checked(name, id, edits);
        assert!(is_sound && said.contains(words), "{name}: no `{words}` in\n{said}");
    }
    let (is_sound, said) = checked(
        "unsigned",
        "direct/velocities-after-impact",
        &[signed[0], (signed[1].0, "the velocity of *A* is {u m/s} and the velocity of *B* is {-w m/s}.")],
    );
    assert!(!is_sound && said.contains("a quantity below nought"), "{said}");
}

#[test]
fn what_is_given_and_what_is_said_of_another_sphere_are_named() {
    found(
        "both-moving/components-given",
        &[(
            "given-answer",
            &[
                (
                    "Find the speed of each sphere immediately",
                    "Find the speed of each sphere and the component of the velocity of *A* perpendicular to the line of centres immediately",
                ),
                (
                    "  { name = \"speed of *B*\", find = \"B.after.speed\", accept = \"awrt 3sf\" },\n",
                    "  { name = \"speed of *B*\", find = \"B.after.speed\", accept = \"awrt 3sf\" },\n  { name = \"component of *A*\", \
                     find = \"A.after.t\", accept = \"awrt 3sf\" },\n",
                ),
            ],
            "warning: `question`: the answer `A.after.t` is a number that the words give, in ",
        )],
    );
    found(
        "ranges/direction-reversed",
        &[(
            "cond-wrong-sphere",
            &[
                ("conditions = [\"A.after.x < 0\"]", "conditions = [\"B.after.x > w\"]"),
                (
                    "The direction of motion of *A* is reversed by the collision. Find",
                    "After the collision the speed of *A* is greater than {w m/s}. Find",
                ),
                ("u  = \"2..12\"", "u  = \"2..12\"\nw = \"1..3\""),
                ("u  = \"5\"", "u  = \"5\"\nw = \"3\""),
                ("require = [\"mA < mB\"]", "require = [\"mA < mB\", \"w < mA*u/(mA+mB)*2\", \"w > mA*u/(mA+mB)\"]"),
            ],
            "the words compare the motion of `*A*` with `w`, and the condition of the scene that of `*B*`",
        )],
    );
    found(
        "direct/velocities-after-impact",
        &[(
            "alike-where-it-can-stand",
            &[("alike = [\"impulse-speed-change = impulse-resultant-speeds\"]\n", "")],
            "write `alike = [\"impulse-speed-change = impulse-resultant-speeds\"]` above the first heading",
        )],
    );
}

#[test]
fn numbers_under_other_names_and_what_the_words_leave_out_are_named() {
    let told = "The coefficient of restitution between the spheres is {e}.";
    found(
        "rest/speeds-and-directions",
        &[
            (
                "friction",
                &[(told, "The coefficient of friction between the spheres is {e}.")],
                "print `e`, and never tell",
            ),
            ("modulus", &[(told, "The modulus of elasticity of the spheres is {e}.")], "print `e`, and never tell"),
            ("energy", &[("the speed of *A* is {u", "the kinetic energy of *A* is {u")], "give `u` as `energy`"),
            ("weight", &[("of mass {mA", "of weight {mA")], "give `mA` as `weight`, and it is a mass"),
            ("second", &[("before the collision", "before the second collision")], "and the scene has one impact"),
            ("rough", &[("smooth uniform sphere", "uniform sphere")], "never say that the spheres are smooth"),
            ("radii", &[(" The spheres have equal radii.", "")], "never say that the spheres have equal radii"),
        ],
    );
    found(
        "walls/rebound-speed-and-direction",
        &[
            ("at-rest", &[("is moving on", "is at rest on")], "a motion that is not so: `at rest`"),
            ("its-energy", &[("the impact the speed of", "the impact the momentum of")], "give `u` as `momentum`"),
            ("plane", &[("smooth horizontal", "horizontal")], "never say that the plane is smooth"),
        ],
    );
    found(
        "direct/one-sphere-catches-the-other",
        &[
            (
                "number",
                &[("Find the speed of *B*", "Find, in terms of {u}, the speed of *B*")],
                "in terms of `u`, which",
            ),
            (
                "loss-of-a",
                &[("energy lost in the", "energy of sphere *A* lost in the")],
                "what *A* loses, and the answer",
            ),
            (
                "one-degree",
                &[("{e}.", "{e}. An angle is {bend}."), ("[let]\n", "[let]\nbend = \"acos(4/5)/deg\"\n")],
                "an angle over one degree: `arccos(4/5)/1°`",
            ),
        ],
    );
    found(
        "i-j/velocities-after-impact",
        &[(
            "speeds",
            &[("in terms of {i} and {j}, the velocity", "the speed")],
            "ask for a speed, and the answer is a vector",
        )],
    );
    found(
        "both-moving/energy-lost-and-impulse",
        &[(
            "on-a",
            &[("exerted on *B*", "exerted on *A*")],
            "impulse on `*A*`, and the answer is called `impulse on B`",
        )],
    );
}

#[test]
fn what_a_condition_compares_with_a_number_is_so_in_the_words() {
    const ASK: &str = "The direction of motion of *A* is reversed by the collision. Find";
    const IF: &str = "\"A.after.x < 0\"";
    const LET: (&str, &str) = ("[style.friendly]\n", "[let]\nw = \"3*mA*u/(2*(mA + mB))\"\n\n[style.friendly]\n");
    const FASTER: (&str, &str) = (IF, "\"B.after.x > w\"");
    found(
        "ranges/direction-reversed",
        &[
            (
                "less-for-more",
                &[LET, FASTER, (ASK, "The speed of *B* is then less than {w m/s}. Find")],
                "the words say `less than` of `w`, and the condition of the scene has `more than`",
            ),
            (
                "at-least",
                &[LET, FASTER, (ASK, "The speed of *B* is then at least {w m/s}. Find")],
                "the words let it be equal to `w`, and the condition of the scene does not",
            ),
            (
                "not-more",
                &[LET, FASTER, (ASK, "The speed of *B* then does not exceed {w m/s}. Find")],
                "the words say `at most` of `w`",
            ),
            (
                "of-another",
                &[LET, FASTER, (ASK, "The speed of *A* is then more than {w m/s}. Find")],
                "the words compare the motion of `*A*` with `w`, and the condition of the scene that of `*B*`",
            ),
            (
                "of-another-kind",
                &[LET, FASTER, (ASK, "The impulse on *B* is more than {w N s}. Find")],
                "the words compare an impulse with `w`, and the condition of the scene the motion",
            ),
            (
                "also-asked",
                &[("possible values of {e}", "possible values of {e}, and the speed of *B* after the collision")],
                "the words ask for the speed of *B* too, and no answer of the part is one",
            ),
        ],
    );
}

#[test]
fn a_mark_that_nobody_can_earn_is_told_of_once() {
    let edits = [("{ code = \"B1\", for = \"perpendicular\" }", "{ code = \"B1\", for = \"impulse\" }")];
    let (_, said) = checked("unearnable", "rest-letters/direction-and-deflection", &edits);
    assert!(said.contains("it is for `impulse`, a step that no answer of its part takes"), "{said}");
    assert_eq!(said.matches("the mark B1a").count(), 1, "{said}");
}
