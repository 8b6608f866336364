//! Diagrams: whatever the scene, no label covers another one, nor a line; and only what is given is drawn.

use std::collections::BTreeMap;

use carom::diagram::{Diagram, Drawing, Frame, Manner, Point, Section, Stroke, given, solution, svg, tikz};
use carom::expr::{Angles, print};
use carom::mechanics::{Scene, SceneText};
use serde_json::{Value as Json, json};

fn scene(text: &Json) -> Scene {
    let text: SceneText<String> = serde_json::from_value(text.clone()).unwrap();
    Scene::read(&text, &BTreeMap::new(), Angles::Radians).unwrap_or_else(|faults| panic!("{text:?}: {faults:?}"))
}

fn drawn(text: &Json, vectors: bool) -> Vec<Diagram> {
    let scene = scene(text);
    let manner = Manner { vectors, with_units: &[], angles: &[] };
    given(&scene, manner).into_iter().chain(solution(&scene, manner)).collect()
}

/// A stroke as short straight pieces.
fn flat(stroke: &Stroke) -> Vec<(Point, Point)> {
    let mut points = vec![stroke.from];
    for piece in &stroke.pieces {
        let from = *points.last().unwrap();
        match *piece {
            Section::Line(end) => points.push(end),
            Section::Curve(one, other, end) => points.extend((1..=24).map(|step| {
                let t = f64::from(step) / 24.0;
                let s = 1.0 - t;
                from * (s * s * s) + one * (3.0 * s * s * t) + other * (3.0 * s * t * t) + end * (t * t * t)
            })),
        }
    }
    points.windows(2).map(|pair| (pair[0], pair[1])).collect()
}

/// What is covered in a drawing, and what lies outside of it.
fn faults(drawing: &Drawing) -> Vec<String> {
    let mut faults = Vec::new();
    let page = Frame { low: drawing.low, high: drawing.high };
    let holds = |point: Point| page.with(point) == page;
    let boxes: Vec<(String, Frame)> = drawing
        .labels
        .iter()
        .map(|label| (print::text_unicode(&label.text), Frame::around(label.centre, label.size)))
        .collect();
    for (place, (name, frame)) in boxes.iter().enumerate() {
        if !holds(frame.low) || !holds(frame.high) {
            faults.push(format!("`{name}` lies outside"));
        }
        for (other, _) in boxes[..place].iter().filter(|(_, other)| frame.meets(*other)) {
            faults.push(format!("`{name}` covers `{other}`"));
        }
        for stroke in &drawing.strokes {
            if flat(stroke).iter().any(|(from, to)| frame.is_crossed(*from, *to)) {
                faults.push(format!("`{name}` covers a line {:?}", stroke.style));
            }
        }
    }
    let outside = drawing.strokes.iter().flat_map(flat).any(|(from, to)| !holds(from) || !holds(to));
    faults.extend(outside.then(|| "a line leaves the picture".to_owned()));
    faults
}

/// Every scene of a family drawn and examined; how many there were.
fn examine(scenes: impl IntoIterator<Item = (Json, bool)>) -> usize {
    let (mut count, mut complaints) = (0, BTreeMap::<String, Vec<String>>::new());
    for (text, vectors) in scenes {
        let diagrams = drawn(&text, vectors);
        assert!(!diagrams.is_empty(), "no picture of {text}");
        for diagram in diagrams {
            count += 1;
            both_notations(&diagram);
            for fault in faults(&diagram.drawing) {
                complaints.entry(fault).or_default().push(format!("{} {text}", diagram.title));
            }
        }
    }
    let told = complaints.iter().map(|(fault, at)| format!("{fault}, {} of {count} times: {}", at.len(), at[0]));
    assert!(complaints.is_empty(), "{}", told.collect::<Vec<_>>().join("\n"));
    count
}

/// A picture has every stroke and every label in both notations.
fn both_notations(diagram: &Diagram) {
    let (html, latex) = (svg(diagram), tikz(&diagram.drawing));
    let drawing = &diagram.drawing;
    let commands = ["\\Rim ", "\\Centres ", "\\Velocity ", "\\Thin ", "\\Dashed ", "\\Filled "];
    let count = |page: &str, sign: &str| page.matches(sign).count();
    assert_eq!(count(&html, "<path "), drawing.strokes.len(), "{html}");
    assert_eq!(commands.iter().map(|command| count(&latex, command)).sum::<usize>(), drawing.strokes.len(), "{latex}");
    assert_eq!(count(&html, "<text "), drawing.labels.len(), "{html}");
    assert_eq!(count(&latex, "\\Label at "), drawing.labels.len(), "{latex}");
    for page in [&html, &latex] {
        assert!(!page.contains("NaN") && !page.contains("inf"), "{page}");
    }
}

fn impact(a: Json, b: Json, line: [&str; 2]) -> Json {
    json!({ "masses": { "A": "3", "B": "12" }, "before": { "A": a, "B": b }, "line_of_centres": line, "sense": "A_to_B", "e": "1/2" })
}

fn polar(speed: &str, degrees: i32) -> Json {
    json!({ "speed": speed, "angle_deg": degrees.to_string() })
}

#[test]
fn nothing_is_covered_at_any_angle_on_either_side_with_b_at_rest() {
    let angles = (-89..=89).map(|degrees| (impact(polar("2*sqrt(3)", degrees), json!(["0", "0"]), ["1", "0"]), false));
    assert!(examine(angles) > 500);
}

#[test]
fn nothing_is_covered_whichever_way_both_move() {
    let mut scenes = Vec::new();
    for a in (-90..=90).step_by(6) {
        for b in (0..360).step_by(9) {
            let (n_a, n_b) = (7.0 * f64::from(a).to_radians().cos(), 2.0 * f64::from(b).to_radians().cos());
            if n_a - n_b > 0.01 {
                scenes.push((impact(polar("7", a), polar("2", b), ["1", "0"]), false));
            }
        }
    }
    assert!(examine(scenes) > 2000);
}

#[test]
fn nothing_is_covered_among_vectors_whatever_the_line_of_centres() {
    let lines = [["1", "0"], ["-1", "0"], ["0", "1"], ["0", "-1"], ["3", "4"], ["-1", "2"], ["5", "-1"], ["-1", "-1"]];
    let mut scenes = Vec::new();
    for line in lines {
        let n = line.map(|part| part.parse::<f64>().unwrap());
        for (p, q, r, s) in
            (0..6 * 6 * 6 * 6).step_by(5).map(|k| (k / 216 - 3, k / 36 % 6 - 2, k / 6 % 6 - 2, k % 6 - 3))
        {
            let approach = f64::from(p - r) * n[0] + f64::from(q - s) * n[1];
            if approach > 0.0 {
                let velocity = |x: i32, y: i32| json!([x.to_string(), y.to_string()]);
                scenes.push((impact(velocity(p, q), velocity(r, s), line), true));
                scenes.push((impact(velocity(p, q), velocity(r, s), line), false));
            }
        }
    }
    assert!(examine(scenes) > 3000);
}

#[test]
fn nothing_is_covered_where_the_line_of_centres_is_found() {
    let found = |b: [i32; 2], after: [i32; 2]| {
        let text = |v: [i32; 2]| v.map(|part| part.to_string());
        json!({ "masses": { "A": "m", "B": "3*m" }, "symbols": { "m": "positive" },
                "before": { "A": ["2", "1"], "B": text(b) }, "after": { "A": text(after) } })
    };
    let mut scenes = Vec::new();
    for (x, y) in (0..81).map(|k| (k / 9 - 4, k % 9 - 4)) {
        for b in [[-1, 0], [-3, 2], [0, -2]] {
            // The spheres approach along the impulse, so that the scene can be posed.
            let approach = (2 - b[0]) * (2 - x) + (1 - b[1]) * (1 - y);
            if approach > 0 {
                scenes.push((found(b, [x, y]), true));
            }
        }
    }
    assert!(examine(scenes) > 150);
}

#[test]
fn nothing_is_covered_in_the_triangle_of_the_centres() {
    let mut scenes = Vec::new();
    for offset in ["0", "r/10", "r/2", "8*r/5", "-24*r/13", "-r", "sqrt(3)*r", "19*r/10", "-199*r/100"] {
        for velocity in [["u", "0"], ["0", "u"], ["-u", "0"], ["3*u", "4*u"], ["-u", "-2*u"], ["u", "-u"]] {
            scenes.push((
                json!({ "masses": { "A": "2*m", "B": "5*m" }, "before": { "A": velocity, "B": ["0", "0"] },
                        "radii": { "A": "r", "B": "r" }, "impact_parameter": offset, "e": "1/3",
                        "symbols": { "m": "positive", "r": "positive", "u": "positive" } }),
                false,
            ));
        }
    }
    assert!(examine(scenes) > 180);
}

#[test]
fn nothing_is_covered_at_a_wall_at_any_angle_and_whichever_way_it_runs() {
    let mut scenes = Vec::new();
    // Every angle with a wall that is parallel to i, from either side; then walls that slant.
    for (wall, normal) in [(["1", "0"], -90), (["0", "1"], 0), (["3", "4"], 143), (["-1", "2"], 27), (["5", "-1"], 79)]
    {
        for degrees in (-89..=89).step_by(if normal == -90 { 1 } else { 7 }) {
            let before = polar("2*sqrt(3)", normal + degrees);
            let text = json!({ "masses": { "A": "12" }, "before": { "A": before }, "wall": wall, "e": "1/2" });
            scenes.push((text, false));
        }
    }
    let lines = [["1", "0"], ["-1", "0"], ["0", "1"], ["3", "4"], ["-1", "2"], ["5", "-1"], ["-1", "-1"]];
    for (wall, [x, y]) in lines.iter().flat_map(|wall| (0..49).map(move |k| (wall, [k / 7 - 3, k % 7 - 3]))) {
        let [p, q] = wall.map(|part| part.parse::<i32>().unwrap());
        if x * q - y * p != 0 {
            let before = [x, y].map(|part| part.to_string());
            let text = json!({ "masses": { "A": "2" }, "before": { "A": before }, "wall": wall, "e": "1/2" });
            scenes.extend([true, false].map(|vectors| (text.clone(), vectors)));
        }
    }
    let letters = json!({ "masses": { "A": "2*m" }, "before": { "A": ["u*cos(alpha)", "-u*sin(alpha)"] }, "wall": ["1", "0"], "e": "e",
                          "symbols": { "m": "positive", "u": "positive", "alpha": "acute", "e": "unit" } });
    scenes.push((letters, false));
    assert!(examine(scenes) > 2000);
}

#[test]
fn nothing_is_covered_in_a_direct_impact_whatever_the_velocities() {
    let mut scenes = Vec::new();
    let (masses, speeds) =
        (["2", "km", "0.25", "3*m/2"], ["5", "-1", "0", "-7/2", "sqrt(2)", "2*u", "u*(1 + e)/4", "-13.75"]);
    for (mass, a, b) in (0..masses.len() * 64).map(|k| (masses[k / 64], speeds[k / 8 % 8], speeds[k % 8])) {
        let scene = |after: Json| {
            let symbols = json!({ "m": "positive", "km": "positive", "u": "positive", "e": "unit" });
            let mut scene =
                json!({ "masses": { "A": mass, "B": "3" }, "before": { "A": a, "B": b }, "symbols": symbols });
            if after.is_null() {
                scene["e"] = json!("2/3");
            } else {
                scene["after"] = after;
            }
            scene
        };
        let texts = [scene(Json::Null), scene(json!({ "A": b })), scene(json!({ "A": b, "B": a }))];
        scenes.extend(texts.into_iter().filter(|text| a != b && can_be_posed(text)).map(|text| (text, false)));
    }
    assert!(examine(scenes) > 500);
}

fn can_be_posed(text: &Json) -> bool {
    carom::mechanics::pose(&scene(text)).is_ok()
}

#[test]
fn nothing_is_covered_around_a_particle_and_in_its_triangle_of_momenta() {
    let mut scenes = Vec::new();
    let around: Vec<[i32; 2]> = (0..81).map(|k| [k / 9 - 4, k % 9 - 4]).filter(|[x, y]| (*x, *y) != (0, 0)).collect();
    for velocity in [[3, 0], [0, -2], [2, 1], [-12, 5], [0, 0]] {
        for [p, q] in &around {
            let text = |v: [i32; 2]| v.map(|part| part.to_string());
            let body = json!({ "masses": { "A": "1/2" }, "before": { "A": text(velocity) } });
            let mut pushed = body.clone();
            pushed["impulse"] = json!(text([*p, *q]));
            let mut found = body;
            found["after"] = json!({ "A": text([*p, *q]) });
            scenes.extend([(pushed, true), (found, true)]);
        }
    }
    let letters = json!({ "masses": { "A": "m" }, "before": { "A": ["3", "1"] }, "impulse": ["k", "2*k"],
                          "symbols": { "m": "positive", "k": "positive" } });
    let backwards = json!({ "masses": { "A": "2" }, "after": { "A": ["3", "1"] }, "impulse": ["7", "-4"] });
    scenes.extend([(letters, true), (backwards, true)]);
    assert!(examine(scenes) > 1000);
}

fn labels(diagram: &Diagram) -> Vec<String> {
    let mut labels: Vec<String> = diagram.drawing.labels.iter().map(|label| print::text_unicode(&label.text)).collect();
    labels.sort();
    labels
}

#[test]
fn a_question_shows_what_is_given_and_nothing_else() {
    let plane = json!({ "masses": { "A": "2*m", "B": "m" }, "symbols": { "m": "positive", "u": "positive", "alpha": "acute", "e": "unit" },
                        "before": { "A": ["u*cos(alpha)", "u*sin(alpha)"], "B": ["0", "0"] }, "line_of_centres": ["1", "0"], "e": "e" });
    let offset = json!({ "masses": { "A": "1", "B": "2" }, "before": { "A": ["3", "0"], "B": ["0", "0"] }, "radii": { "A": "1/2", "B": "1/2" },
                         "impact_parameter": "-3/5", "e": "1/3" });
    let backwards = json!({ "masses": { "A": "1", "B": "2" }, "before": { "A": ["3", "1"], "B": ["0", "0"] }, "after": { "A": ["1", "-1"] } });
    let wall = json!({ "masses": { "A": "2" }, "before": { "A": polar("10", -30) }, "wall": ["1", "0"], "e": "1/2" });
    let direct = json!({ "masses": { "A": "2*m", "B": "k*m" }, "before": { "A": "3*u", "B": "-u" }, "after": { "A": "u" },
                         "symbols": { "m": "positive", "u": "positive", "k": "positive" } });
    let pushed = json!({ "masses": { "A": "2" }, "before": { "A": ["3", "1"] }, "impulse": ["-8", "6"] });
    let changed = json!({ "masses": { "A": "2" }, "before": { "A": ["3", "1"] }, "after": { "A": ["-1", "4"] } });
    type Case<'a> = (Json, bool, &'a [&'a str]);
    let cases: [Case; 10] = [
        (wall, false, &["10 m s⁻¹", "2 kg", "30°", "A"]),
        (direct, false, &["2m", "3u", "A", "B", "km", "u", "2m", "A", "B", "km", "u"]),
        (pushed, true, &["(3i + j) m s⁻¹", "(−8i + 6j) N s", "2 kg", "A", "i", "j"]),
        (changed, true, &["(3i + j) m s⁻¹", "2 kg", "A", "i", "j", "(−i + 4j) m s⁻¹", "2 kg", "A", "i", "j"]),
        (
            impact(polar("6", 30), json!(["0", "0"]), ["1", "0"]),
            false,
            &["12 kg", "3 kg", "30°", "6 m s⁻¹", "A", "B", "at rest", "line of centres"],
        ),
        (
            impact(json!(["4", "-1"]), json!(["-3", "2"]), ["1", "0"]),
            true,
            &["(4i − j) m s⁻¹", "(−3i + 2j) m s⁻¹", "12 kg", "3 kg", "A", "B", "i", "j", "line of centres"],
        ),
        (
            impact(json!(["4", "5"]), json!(["-2", "0"]), ["1", "0"]),
            false,
            &["12 kg", "2 m s⁻¹", "3 kg", "4 m s⁻¹", "5 m s⁻¹", "A", "B", "line of centres"],
        ),
        (plane, false, &["2m", "A", "B", "at rest", "line of centres", "m", "u", "α"]),
        (offset, false, &["1 kg", "1/2", "2 kg", "3 m s⁻¹", "3/5", "A", "B", "at rest"]),
        (backwards, true, &[]),
    ];
    for (text, vectors, expected) in cases {
        let figures = given(&scene(&text), Manner { vectors, with_units: &[], angles: &[] });
        let shown: Vec<String> = figures.iter().flat_map(labels).collect();
        assert_eq!(shown, expected, "{text}");
    }
}

#[test]
fn the_words_of_a_figure_tell_all_that_is_written_in_it() {
    let mut scenes = vec![(impact(json!(["4", "-1"]), json!(["-3", "2"]), ["0", "1"]), true)];
    scenes.extend((0..=90).step_by(15).map(|b| (impact(polar("7", 25), polar("2", 180 - b), ["1", "0"]), false)));
    scenes.push((impact(json!(["4", "5"]), json!(["-2", "0"]), ["1", "0"]), false));
    scenes.push((
        json!({ "masses": { "A": "2" }, "before": { "A": polar("10", -30) }, "wall": ["1", "0"], "e": "1/2" }),
        false,
    ));
    scenes
        .push((json!({ "masses": { "A": "2" }, "before": { "A": ["7", "1"] }, "wall": ["3", "4"], "e": "1/2" }), true));
    scenes.push((json!({ "masses": { "A": "2", "B": "3" }, "before": { "A": "5", "B": "-1" }, "e": "1/2" }), false));
    scenes.push((json!({ "masses": { "A": "2" }, "before": { "A": ["3", "1"] }, "impulse": ["-8", "6"] }), true));
    for (text, vectors) in scenes {
        for figure in drawn(&text, vectors) {
            for label in labels(&figure).into_iter().filter(|label| label != "positive") {
                assert!(figure.words.contains(&label), "{text}: `{label}` is not in: {}", figure.words);
            }
        }
    }
    let [figure] = &given(
        &scene(&impact(polar("6", 30), json!(["0", "0"]), ["1", "0"])),
        Manner { vectors: false, with_units: &[], angles: &[] },
    )[..] else {
        panic!("one figure")
    };
    assert_eq!(
        figure.words,
        "Two spheres seen from above as they touch. The line of centres runs to the right, from A to B. Immediately before the \
         impact A, of mass 3 kg, moves with speed 6 m s⁻¹ to the right and up the page, at an angle of 30° to the line of \
         centres. Immediately before the impact B, of mass 12 kg, is at rest."
    );
}
