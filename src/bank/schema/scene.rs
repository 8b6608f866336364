//! The scene of a question, and what belongs to it.

use serde_json::{Value as Json, json};

use super::{NAME, quantity, several, shared, table, texts, words};
use crate::mechanics::Sphere;
use crate::number::Range;

pub fn vector(description: &str) -> Json {
    json!({
        "description": description, "type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "string"},
    })
}

fn pair(description: &str, each: Json) -> Json {
    table(description, vec![("A", each.clone()), ("B", each)], &[])
}

pub fn scene() -> Json {
    let ranges: Vec<String> = Range::DECLARED.iter().map(|(name, _)| (*name).to_owned()).collect();
    table(
        "The collision, in parameters, derived names and letters. The x-axis is i; angles are in degrees.",
        vec![
            ("masses", pair("The masses, in kg.", words("A number or formula."))),
            ("before", pair("The velocities immediately before the collision, in m/s.", shared("velocity"))),
            ("after", pair("Velocities immediately after it, where they are given.", shared("velocity"))),
            (
                "line_of_centres",
                vector("A vector along the line of centres; [\"1\", \"0\"] for i. Any length will do."),
            ),
            (
                "sense",
                json!({
                    "description": "Which way it points: from A to B; or either, if that is to be found from the approach.",
                    "enum": ["A_to_B", "either"],
                }),
            ),
            (
                "positions",
                pair("Where the centres are at the collision, in place of the line of centres.", shared("vector")),
            ),
            ("radii", pair("The radii of both spheres, in metres.", words("A number or formula."))),
            ("impact_parameter", words("How far B's centre lies to the left of A's path, as A moves relative to B.")),
            (
                "wall",
                vector("A vector along a fixed smooth wall that A strikes, in place of B and the line of centres."),
            ),
            ("impulse", vector("The impulse that A receives, in N s, where it is one particle by itself.")),
            ("e", words("The coefficient of restitution.")),
            (
                "symbols",
                json!({
                    "description": "Letters that stay letters, and what they may be.", "type": "object",
                    "propertyNames": {"pattern": NAME}, "additionalProperties": {"enum": ranges},
                }),
            ),
            ("unknowns", texts("Letters that are to be found from the conditions.")),
            (
                "conditions",
                texts(
                    "What must hold: an equation such as \"A.deflection_dot = 0\", or an inequality such as \"A.after.x < 0\".",
                ),
            ),
            (
                "maximise",
                json!({
                    "description": "The quantity that is to be as large as possible.", "anyOf": quantity()["anyOf"],
                }),
            ),
            ("then", several("later_impact", "The impacts that come later, in their order.")),
        ],
        &[],
    )
}

pub fn later_impact() -> Json {
    let spheres = Sphere::ALL.map(Sphere::name);
    let mut impact = table(
        "An impact that comes after another. Masses and velocities are those that the spheres have by then.",
        vec![
            (
                "of",
                json!({
                    "description": "Who meets, along one line in their order on it; one alone strikes a wall.",
                    "type": "array", "minItems": 1, "maxItems": 2, "items": {"enum": spheres},
                }),
            ),
            ("mass", words("The mass of the one that takes part for the first time, in kg.")),
            ("before", shared("velocity")),
            ("line_of_centres", vector("A vector along the line of centres, where the spheres are not in one line.")),
            (
                "sense",
                json!({
                    "description": "Which way it points: from the first to the second; or either, as they approach.",
                    "enum": ["A_to_B", "either"],
                }),
            ),
            ("wall", vector("A vector along a fixed smooth wall.")),
            ("e", words("The coefficient of restitution.")),
        ],
        &["of"],
    );
    impact["oneOf"] = json!([
        {"required": ["wall"], "properties": {"of": {"maxItems": 1}}},
        {"not": {"required": ["wall"]}, "properties": {"of": {"minItems": 2}}},
    ]);
    impact
}

pub fn velocity() -> Json {
    let mut polar = table(
        "A speed and a direction, anticlockwise from i.",
        vec![
            ("speed", words("How fast, in m/s.")),
            ("angle_deg", words("The direction in degrees, anticlockwise from i.")),
            ("cos", words("In place of the angle: its cosine.")),
            ("sin", words("In place of the angle: its sine.")),
        ],
        &["speed"],
    );
    polar["oneOf"] = json!([
        {"required": ["angle_deg"], "not": {"anyOf": [{"required": ["cos"]}, {"required": ["sin"]}]}},
        {"required": ["cos", "sin"], "not": {"required": ["angle_deg"]}},
    ]);
    let along = words("Along the one line of a direct impact: signed, positive from A to B.");
    json!({
        "description": "A velocity: two components, a speed with a direction, or one number along the line of a direct impact.",
        "anyOf": [shared("vector"), polar, along],
    })
}
