//! Diagrams: whatever the scene, no label covers another one, nor a line; and only what is given is drawn.

use std::collections::BTreeMap;

use carom::diagram::{
    Diagram, Drawing, Frame, Label, Manner, Point, Section, Stroke, Style, given, solution, svg, tikz,
};
use carom::expr::{Angles, Expr, number, print, read};
use carom::mechanics::{Scene, SceneText};
use serde_json::{Value as Json, json};

fn scene(text: &Json) -> Scene {
    let text: SceneText<String> = serde_json::from_value(text.clone()).unwrap();
    Scene::read(&text, &(), Angles::Radians).unwrap_or_else(|faults| panic!("{text:?}: {faults:?}"))
}

fn drawn(text: &Json, vectors: bool) -> Vec<Diagram> {
    let scene = scene(text);
    let manner = Manner { vectors, with_units: &[], angles: &[], after_walls: &[] };
    given(&scene, manner).into_iter().chain(solution(&scene, manner).into_iter().flatten()).collect()
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

/// Scenes whose line of centres is to be found from what is given after the impact.
fn backwards() -> Vec<Json> {
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
                scenes.push(found(b, [x, y]));
            }
        }
    }
    scenes
}

#[test]
fn nothing_is_covered_where_the_line_of_centres_is_found() {
    assert!(examine(backwards().into_iter().map(|text| (text, true))) > 150);
}

#[test]
fn no_arrow_points_into_a_sphere_after_the_impact_nor_goes_through_one() {
    let (mut leaving, mut beside) = (0, 0);
    for text in backwards() {
        let after = drawn(&text, true).into_iter().find(|diagram| diagram.title == "After").unwrap();
        let styled = |style| after.drawing.strokes.iter().filter(move |stroke| stroke.style == style).map(flat);
        let middle = |rim: Vec<(Point, Point)>| {
            rim.iter().fold(Point::new(0.0, 0.0), |sum, (from, _)| sum + *from) * (1.0 / rim.len() as f64)
        };
        let spheres: Vec<(Point, f64)> = styled(Style::Rim)
            .map(|rim| {
                let start = rim[0].0;
                let centre = middle(rim);
                (centre, (start - centre).length())
            })
            .collect();
        for arrow in styled(Style::Velocity) {
            let (from, to) = arrow[0];
            let from_nearest = spheres.iter().map(|(centre, radius)| (from - *centre).length() - radius);
            if from_nearest.fold(f64::INFINITY, f64::min) < 1e-3 {
                leaving += 1;
            } else {
                beside += 1;
            }
            for (centre, radius) in &spheres {
                let points = (0..=40).map(|step| from + (to - from) * (f64::from(step) / 40.0));
                let gap = points.map(|point| (point - *centre).length() - radius).fold(f64::INFINITY, f64::min);
                assert!(gap > -1e-3, "{gap}: {text}");
                // What ends at a rim points into it.
                assert!((to - *centre).length() - radius > 0.4, "{text}");
            }
        }
    }
    assert!(leaving > 100 && beside > 0, "{leaving} {beside}");
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

/// A strikes B; then one of them strikes C, which moves on the same line, or a wall at its end, or one after the other.
fn along_a_line() -> Vec<Json> {
    let third = |of: [&str; 2], speed: &str| json!({ "of": of, "mass": "3*m/2", "before": speed, "e": "1/2" });
    let wall = |of: &str| json!({ "of": [of], "wall": ["0", "1"], "e": "1/3" });
    let mut scenes = Vec::new();
    for speed in ["0", "-1", "-13.75", "u*(1 + e)/4", "-2*u"] {
        for then in [
            json!([third(["B", "C"], speed)]),
            json!([third(["C", "A"], speed)]),
            json!([wall("B")]),
            json!([wall("A")]),
            json!([third(["B", "C"], speed), wall("C")]),
            json!([third(["B", "C"], speed), wall("A")]),
            json!([third(["C", "A"], speed), wall("C"), wall("B")]),
        ] {
            let symbols = json!({ "m": "positive", "u": "positive", "e": "unit" });
            // Who strikes what is behind it has been turned back.
            let is_turned = then
                .as_array()
                .unwrap()
                .iter()
                .any(|impact| impact["of"] == json!(["A"]) || impact["of"] == json!(["C", "A"]));
            let [a, b] = if is_turned { ["0.25", "2"] } else { ["2", "0.25"] };
            let masses = json!({ "A": a, "B": b });
            scenes.push(json!({ "masses": masses, "before": { "A": "5", "B": "-1" }, "e": "2/3", "symbols": symbols, "then": then }));
        }
    }
    scenes
}

#[test]
fn nothing_is_covered_further_along_the_line_and_all_of_it_is_told() {
    for text in along_a_line() {
        let figures = given(&scene(&text), Manner { vectors: false, with_units: &[], angles: &[], after_walls: &[] });
        assert_eq!(figures.len(), 1, "{text}");
        both_notations(&figures[0]);
        assert_eq!(faults(&figures[0].drawing), Vec::<String>::new(), "{text}");
        let (text, words) = (text.to_string(), &figures[0].words);
        for label in labels(&figures[0]) {
            assert!(words.contains(&label), "{text}: `{label}` is not in: {words}");
        }
        assert_eq!(words.contains("Three spheres"), text.contains("3*m/2"), "{words}");
        for (of, side) in
            [("A", "left"), ("B", "right"), ("C", if text.contains("[\"C\",") { "left" } else { "right" })]
        {
            let is_wall = text.contains(&format!("\"of\":[\"{of}\"]"));
            let said = format!("A wall stands to the {side} of {of}, across the line.");
            assert_eq!(words.contains(&said), is_wall, "{text}: {words}");
        }
    }
}

/// A strikes a wall at an angle with it, and then another wall, whichever way both run.
fn between_two_walls() -> Vec<(Json, bool)> {
    let wall = |degrees: i32| json!([format!("cos({degrees} deg)"), format!("sin({degrees} deg)")]);
    let mut scenes = Vec::new();
    let mut add = |first: &Json, second: &Json, before: Json, vectors: bool| {
        let then = json!([{ "of": ["A"], "wall": second, "e": "1/3" }]);
        let text =
            json!({ "masses": { "A": "12" }, "before": { "A": before }, "wall": first, "e": "2/3", "then": then });
        scenes.push((text, vectors));
    };
    // By their angle, the first across the page; then by vectors along them.
    for (second, degrees) in
        (15..=165).step_by(15).flat_map(|second| (10..370).step_by(30).map(move |degrees| (second, degrees)))
    {
        add(&json!(["1", "0"]), &wall(second), polar("2*sqrt(3)", degrees), false);
    }
    let along = [["1", "0"], ["0", "1"], ["3", "4"], ["-1", "5"], ["1", "-1"]].map(|wall| json!(wall));
    for (first, second) in along.iter().flat_map(|first| along.iter().map(move |second| (first, second))) {
        for velocity in (0..49).step_by(4).map(|k| [k / 7 - 3, k % 7 - 3].map(|part| part.to_string())) {
            add(first, second, json!(velocity), true);
        }
    }
    scenes.retain(|(text, _)| can_be_posed(text));
    scenes
}

/// The walls of a picture: straight lines with the weight of a rim.
fn walls(diagram: &Diagram) -> Vec<(Point, Point)> {
    let straight = |stroke: &&Stroke| stroke.style == Style::Rim && matches!(stroke.pieces[..], [Section::Line(_)]);
    diagram.drawing.strokes.iter().filter(straight).flat_map(flat).collect()
}

/// Do two lines cross, and not only touch?
fn cross((a, b): (Point, Point), (c, d): (Point, Point)) -> bool {
    let side = |p: Point, q: Point, r: Point| (q - p).unit().turned().dot(r - p);
    let apart = |one: f64, other: f64| one.min(other) < -0.01 && one.max(other) > 0.01;
    apart(side(a, b, c), side(a, b, d)) && apart(side(c, d, a), side(c, d, b))
}

#[test]
fn both_walls_are_there_whichever_way_they_run_and_nothing_goes_through_them() {
    let (angles, after_walls) = ([], [(0, Expr::name("beta")), (1, Expr::name("gamma"))]);
    let mut complaints = Vec::new();
    let (mut count, mut far) = (0, 0);
    for (text, vectors) in between_two_walls() {
        let manner = Manner { vectors, with_units: &[], angles: &angles, after_walls: &after_walls };
        let (figures, solutions) = (given(&scene(&text), manner), solution(&scene(&text), manner));
        assert_eq!((figures.len(), solutions.iter().map(Vec::len).collect::<Vec<_>>()), (1, vec![2, 2]), "{text}");
        let same = text["wall"] == text["then"][0]["wall"];
        for figure in figures.iter().chain(solutions.iter().flatten()) {
            count += 1;
            both_notations(figure);
            let (shown, walls) = (labels(figure), walls(figure));
            // Walls that are parallel are two if they face each other, and one if the sphere strikes it twice.
            let two = walls.len() == 2;
            let mut say = |fault: String| complaints.push(format!("{fault}: {} {text}", figure.title));
            faults(&figure.drawing).into_iter().for_each(&mut say);
            if !two && !same {
                say("a wall is not there".to_owned());
            }
            let named = two && !figure.title.starts_with("After");
            for wall in ["first wall", "second wall"] {
                if shown.iter().any(|label| label == wall) != named {
                    say(format!("`{wall}` is out of its place"));
                }
            }
            for label in &shown {
                if !figure.words.contains(label) {
                    say(format!("`{label}` is not in: {}", figure.words));
                }
            }
            let moved = figure
                .drawing
                .strokes
                .iter()
                .filter(|stroke| stroke.style != Style::Rim && stroke.style != Style::Thin);
            if moved.flat_map(flat).any(|line| walls.iter().any(|wall| cross(line, *wall))) {
                say("something goes through a wall".to_owned());
            }
        }
        // Where the way to the second wall is long, only its beginning is drawn.
        far += usize::from(!labels(&figures[0]).contains(&"γ".to_owned()));
    }
    assert!(
        complaints.is_empty(),
        "{} of {count}:\n{}",
        complaints.len(),
        complaints[..complaints.len().min(20)].join("\n")
    );
    assert!(count > 1000 && 10 * far < count, "{far} of {count}");
}

#[test]
fn a_wall_beyond_two_spheres_is_clear_of_them_whichever_way_it_runs() {
    let mut scenes = Vec::new();
    for (line, of) in
        [["1", "0"], ["0", "1"], ["3", "4"], ["-1", "2"]].iter().flat_map(|line| ["A", "B"].map(|of| (line, of)))
    {
        for (wall, b) in (0..180).step_by(30).flat_map(|wall| [["0", "0"], ["-1", "-2"]].map(move |b| (wall, b))) {
            let wall = json!([format!("cos({wall} deg)"), format!("sin({wall} deg)")]);
            let mut text = impact(json!(["4", "5"]), json!(b), *line);
            text["then"] = json!([{ "of": [of], "wall": wall, "e": "1/3" }]);
            scenes.extend([true, false].map(|vectors| (text.clone(), vectors)));
        }
    }
    scenes.retain(|(text, _)| can_be_posed(text));
    assert!(scenes.len() > 100);
    for (text, vectors) in scenes {
        let manner = Manner { vectors, with_units: &[], angles: &[], after_walls: &[] };
        let figures = given(&scene(&text), manner);
        let [figure] = &figures[..] else { panic!("{text}: {} figures", figures.len()) };
        both_notations(figure);
        assert_eq!(faults(&figure.drawing), Vec::<String>::new(), "{text}");
        let walls = walls(figure);
        assert_eq!(walls.len(), 1, "{text}");
        let moved = figure.drawing.strokes.iter().filter(|stroke| stroke.style != Style::Thin);
        assert!(!moved.flat_map(flat).any(|line| cross(line, walls[0])), "{text}");
        let said = format!("from {} it lies", text["then"][0]["of"][0].as_str().unwrap());
        assert!(figure.words.contains(" A wall runs ") && figure.words.contains(&said), "{text}: {}", figure.words);
    }
}

/// How far a label is from a straight line.
fn off_line((from, to): (Point, Point), label: &Label) -> f64 {
    let frame = Frame::around(label.centre, label.size);
    let points = (0..=20).map(|step| from + (to - from) * (f64::from(step) / 20.0));
    let off = |point: Point| {
        let nearest = Point::new(point.x.clamp(frame.low.x, frame.high.x), point.y.clamp(frame.low.y, frame.high.y));
        (point - nearest).length()
    };
    points.map(off).fold(f64::INFINITY, f64::min)
}

/// How far a label is from the nearest arrow.
fn off_its_arrow(drawing: &Drawing, label: &Label) -> f64 {
    let arrows = drawing.strokes.iter().filter(|stroke| stroke.style == Style::Velocity).flat_map(flat);
    arrows.map(|line| off_line(line, label)).fold(f64::INFINITY, f64::min)
}

#[test]
fn what_is_said_of_a_velocity_stands_at_its_arrow() {
    let (mut complaints, mut count) = (Vec::new(), 0);
    let mut examine = |text: Json, vectors: bool| {
        let manner = Manner { vectors, with_units: &[], angles: &[], after_walls: &[] };
        for figure in given(&scene(&text), manner) {
            let of_velocity = |label: &&Label| print::text_unicode(&label.text).contains("m s⁻¹");
            for label in figure.drawing.labels.iter().filter(of_velocity) {
                count += 1;
                let off = off_its_arrow(&figure.drawing, label);
                if off > 0.8 {
                    complaints.push(format!(
                        "`{}` is {off:.2} off at {:?} {:?}: {text}",
                        print::text_unicode(&label.text),
                        label.centre,
                        label.size
                    ));
                }
            }
        }
    };
    for (a, b) in (0..36)
        .map(|k| (["5", "1", "7/2", "13.75", "-1", "14/3"][k / 6], ["-5", "-1", "0", "-7/2", "-13.75", "-14/3"][k % 6]))
    {
        let text = json!({ "masses": { "A": "2", "B": "3" }, "before": { "A": a, "B": b }, "e": "2/3" });
        if can_be_posed(&text) {
            examine(text, false);
        }
    }
    for (x, y) in (0..81).map(|k| (k / 9 - 4, k % 9 - 4)).filter(|place| *place != (0, 0)) {
        let velocity = [x, y].map(|part| part.to_string());
        examine(json!({ "masses": { "A": "2" }, "before": { "A": velocity }, "impulse": ["-8", "6"] }), true);
        if y < 0 {
            examine(
                json!({ "masses": { "A": "2" }, "before": { "A": velocity }, "wall": ["1", "0"], "e": "1/2" }),
                true,
            );
        }
        if x > 0 {
            examine(impact(json!(velocity), json!(["0", "0"]), ["1", "0"]), true);
        }
    }
    assert!(complaints.is_empty(), "{} of {count}:\n{}", complaints.len(), complaints.join("\n"));
    assert!(count > 150);
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

#[test]
fn what_is_said_of_a_momentum_stands_nearest_to_its_own_arrow() {
    let (mut count, mut complaints) = (0, Vec::new());
    let whole = || (-7..=7).flat_map(|x| (-7..=7).map(move |y| [x, y]));
    for (place, (before, impulse)) in whole().flat_map(|u| whole().map(move |impulse| (u, impulse))).enumerate() {
        let text = |v: [i32; 2]| v.map(|part| part.to_string());
        let body = json!({ "masses": { "A": "2" }, "before": { "A": text(before) }, "impulse": text(impulse) });
        if place % 7 != 0 || !can_be_posed(&body) {
            continue;
        }
        let Some(triangle) = drawn(&body, true).into_iter().find(|diagram| diagram.title == "Momentum") else {
            continue;
        };
        let thick = triangle.drawing.strokes.iter().filter(|stroke| stroke.style == Style::Velocity).flat_map(flat);
        let thick: Vec<(Point, Point)> = thick.collect();
        let sides = [thick[0], (thick[0].1, thick[1].1), thick[1]];
        for (own, label) in triangle.drawing.labels[..3].iter().enumerate() {
            count += 1;
            // A label at a corner, where two arrows meet, would be as near to either.
            let middle = Label { size: Point::new(0.0, 0.0), ..label.clone() };
            let off = sides.map(|side| off_line(side, &middle));
            if (0..3).any(|other| other != own && off[other] < off[own] + 0.01) {
                complaints.push(format!("`{}` {off:.2?}: {body}", print::text_unicode(&label.text)));
            }
        }
    }
    // Long labels around a narrow triangle have nowhere else to go.
    assert!(complaints.len() * 300 < count, "{} of {count}:\n{}", complaints.len(), complaints.join("\n"));
    assert!(count > 10000, "{count}");
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
        (changed, true, &["(3i + j) m s⁻¹", "2 kg", "A", "i", "j", "(−i + 4j) m s⁻¹", "2 kg", "A"]),
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
        let figures = given(&scene(&text), Manner { vectors, with_units: &[], angles: &[], after_walls: &[] });
        let shown: Vec<String> = figures.iter().flat_map(labels).collect();
        assert_eq!(shown, expected, "{text}");
    }
    // The angle after the impact that is given, at the way from the wall.
    let text = json!({ "masses": { "A": "2" }, "before": { "A": { "speed": "5", "cos": "2/sqrt(13)", "sin": "-3/sqrt(13)" } }, "wall": ["1", "0"], "e": "e", "unknowns": ["e"],
                       "symbols": { "e": "unit" }, "conditions": ["A.after.tan_to_wall = 3/4"] });
    let angles = [("alpha", "3/2"), ("beta", "3/4")].map(|(name, tangent)| {
        (Expr::name(name), number(&read(tangent, Angles::Radians).unwrap(), &|_| None).unwrap())
    });
    let manner = Manner { vectors: false, with_units: &[], angles: &angles, after_walls: &[] };
    let shown: Vec<String> = given(&scene(&text), manner).iter().flat_map(labels).collect();
    assert_eq!(shown, ["2 kg", "5 m s⁻¹", "A", "α", "β"]);
}

/// What is given of the motion after an impact, along i and j, is drawn along the line of centres.
#[test]
fn a_velocity_after_the_impact_that_is_given_has_its_components_in_the_solution() {
    let manner = Manner { vectors: true, with_units: &[], angles: &[], after_walls: &[] };
    let wall = json!({ "masses": { "A": "2" }, "before": { "A": ["2", "5"] }, "after": { "A": ["-2", "3"] },
                       "wall": ["-1", "2"] });
    let along_i = json!({ "masses": { "A": "2" }, "before": { "A": ["4", "-3"] }, "after": { "A": ["4", "3"] },
                          "wall": ["1", "0"] });
    for (text, size) in [(wall, "√5/5"), (along_i, "3")] {
        let pictures: Vec<Diagram> = solution(&scene(&text), manner).into_iter().flatten().collect();
        let after = labels(pictures.last().unwrap());
        assert!(after.iter().any(|label| label.starts_with(size)) && !after.contains(&"0".to_owned()), "{after:?}");
    }
}

/// The line of centres lies across the page, and i and j would lie as nobody draws them.
#[test]
fn the_solution_of_an_oblique_line_of_centres_has_no_unit_vectors() {
    let manner = Manner { vectors: true, with_units: &[], angles: &[], after_walls: &[] };
    for (line, expected) in [(["3", "1"], 0), (["1", "0"], 1), (["0", "1"], 1)] {
        let text = impact(json!(["4", "5"]), json!(["-3", "0"]), line);
        let pictures: Vec<Diagram> = solution(&scene(&text), manner).into_iter().flatten().collect();
        let with_axes = pictures.iter().filter(|picture| labels(picture).contains(&"i".to_owned())).count();
        assert_eq!(with_axes, expected, "{line:?}");
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
        Manner { vectors: false, with_units: &[], angles: &[], after_walls: &[] },
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
