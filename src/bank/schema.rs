//! A question file as a JSON Schema, for editors: what may stand in it, what each key is for, and which names there are.
//!
//! Names of quantities, steps, kinds, codes and styles come from the lists by which files are read, so they cannot differ;
//! the keys of each table are compared with those that the reader asks for by the tests below. Draft 7 it is, since
//! editors of TOML know no later one.

use serde_json::{Map, Value as Json, json};

mod scene;

use scene::{later_impact, scene, vector, velocity};

use super::EarnedFor;
use super::question::{Code, StyleName};
use crate::answer::Kind;
use crate::mechanics::{LATER, Quantity, Sphere};

/// A name that a person gives: a letter, then letters, digits or `_`.
const NAME: &str = "^[A-Za-z][A-Za-z0-9_]*$";

/// The rules of acceptance as a pattern; `exact`, `awrt 3sf`, `2dp`, `nearest 1`, and the words that may follow.
const ACCEPT: &str = "^\\s*((exact|(awrt )?\\s*\\d+\\s*(sf|dp)|(awrt )?\\s*nearest .+)(\\s+(or better|or exact|oe|isw|cao))*\
                      |(oe|isw|cao)(\\s+(oe|isw|cao))*)\\s*$";

/// The schema of a question file.
///
/// ```
/// let schema = carom::bank::question_schema();
/// let codes = &schema["definitions"]["mark"]["properties"]["code"]["enum"];
/// assert!(codes.as_array().unwrap().contains(&"dM1".into()));
/// ```
pub fn question_schema() -> Json {
    let mut schema = table(
        "One question of a bank: its words, its numbers, what is asked and what earns the marks. Carom derives the answers.",
        vec![
            ("title", words("The heading of the question in lists.")),
            ("mirrors", words("The exercise whose skills it practises, such as 5C-2.")),
            ("topic", words("The topic under which it is listed; `carom sheet --topic` chooses by it.")),
            ("stem", words(STEM)),
            ("require", texts(REQUIRE)),
            ("parameters", shared("parameters")),
            ("let", shared("let")),
            ("style", styles()),
            ("scene", shared("scene")),
            ("part", several("part", "What is asked. One part has no letter; two are labelled (a) and (b).")),
            ("reference", reference()),
            ("hidden", texts("Slips of students that some of the numbers hide, by their tags, such as e-taken-as-1.")),
            ("alike", texts("Pairs of slips that no number tells apart, such as: speed-sum = speed-no-root.")),
            ("test", several("test", "Answers that you have worked out yourself, to be compared with those of carom.")),
        ],
        &["title", "topic", "stem", "style", "scene", "part", "reference"],
    );
    let definitions = json!({
        "parameters": free("The values that each number may take.", shared("domain")),
        "domain": domain(),
        "let": free("Names worked out from the parameters, each from those before it.", words("A formula, such as mA/e.")),
        "style": style(),
        "scene": scene(),
        "vector": vector("Two components: along i and along j."),
        "velocity": velocity(),
        "later_impact": later_impact(),
        "part": part(),
        "answer": answer(),
        "mark": mark(),
        "test": test(),
    });
    schema["definitions"] = definitions;
    // What an answer finds, and what a mark is for, may be a letter only where the scene has letters to find.
    schema["if"] = json!({"properties": {"scene": {"required": ["unknowns"]}}});
    schema["else"] = json!({"properties": {"part": {"items": {"properties": {
        "answers": {"items": {"properties": {"find": either(&[quantity(), list_of(quantity())])}}},
        "marks": {"items": {"properties": {"for": either(&[one_of(&steps()), of_later(), of_two()])}}},
    }}}}});
    let mut whole = Map::new();
    whole.insert("$schema".to_owned(), "http://json-schema.org/draft-07/schema#".into());
    whole.insert("$id".to_owned(), "question.schema.json".into());
    whole.insert("title".to_owned(), "A question of a carom bank".into());
    if let Json::Object(rest) = schema {
        whole.extend(rest);
    }
    whole.into()
}

const STEM: &str = "The words before part (a); a blank line begins a paragraph. *A* is the name of a sphere, {u m/s} a \
number with its unit, {[p, q] m/s} a velocity in i and j, {e} a formula, _words_ italics.";

const REQUIRE: &str = "What must be true of the numbers and of the results; numbers for which it is not are never printed. \
\"mA != mB\", \"A.after.n > 0\", \"A.after.speed is an integer\", \"A.deflection_deg = 90\", \"e = 5/7\".";

/// A table with these keys and no others.
fn table(description: &str, keys: Vec<(&str, Json)>, required: &[&str]) -> Json {
    let properties: Map<String, Json> = keys.into_iter().map(|(name, schema)| (name.to_owned(), schema)).collect();
    json!({
        "description": description, "type": "object", "properties": properties, "required": required,
        "additionalProperties": false,
    })
}

/// A table whose keys a person chooses.
fn free(description: &str, values: Json) -> Json {
    json!({
        "description": description, "type": "object", "propertyNames": {"pattern": NAME}, "additionalProperties": values,
    })
}

fn words(description: &str) -> Json {
    json!({"description": description, "type": "string"})
}

fn texts(description: &str) -> Json {
    json!({"description": description, "type": "array", "uniqueItems": true, "items": {"type": "string"}})
}

fn list_of(items: Json) -> Json {
    json!({"type": "array", "items": items, "minItems": 1, "maxItems": 2, "uniqueItems": true})
}

fn one_of(names: &[String]) -> Json {
    json!({"enum": names})
}

fn either(choices: &[Json]) -> Json {
    json!({"anyOf": choices})
}

/// The schema as it stands among the definitions.
fn shared(name: &str) -> Json {
    json!({"$ref": format!("#/definitions/{name}")})
}

/// One or more tables, each after its own `[[name]]`.
fn several(name: &str, description: &str) -> Json {
    json!({"description": description, "type": "array", "minItems": 1, "items": shared(name)})
}

fn domain() -> Json {
    json!({
        "description": "A range \"2..12\" or \"10..80 step 5\", or a list [\"1/4\", \"1/3\"]. Numbers stand in quotes.",
        "anyOf": [
            {"type": "string"},
            {"type": "array", "minItems": 1, "uniqueItems": true,
             "items": {"type": "string", "pattern": "^((?!\\.\\.).)*$"}},
        ],
    })
}

fn styles() -> Json {
    let each: Map<String, Json> =
        StyleName::ALL.into_iter().map(|style| (style.name().to_owned(), shared("style"))).collect();
    json!({
        "description": "The styles in which the question is offered: friendly (whole numbers and short fractions), exact \
                        (surds), calculator (rounded answers). One is enough, and may be empty.",
        "type": "object", "minProperties": 1, "properties": each, "additionalProperties": false,
    })
}

fn style() -> Json {
    table(
        "What this style adds to the question, or has in place of it.",
        vec![
            ("stem", words("Other words before part (a).")),
            ("note", words("A line after the stem, such as: Give your answers to 3 significant figures.")),
            (
                "exact",
                texts(
                    "Answers that must be exact in this style, by their names: speed of *A*. The others are accepted \
                             as they say themselves.",
                ),
            ),
            ("require", texts(REQUIRE)),
            ("parameters", shared("parameters")),
            ("let", shared("let")),
        ],
        &[],
    )
}

fn test() -> Json {
    table(
        "Answers for one set of numbers: the reference numbers, but for those that `numbers` has.",
        vec![
            ("style", words("The style whose numbers these are.")),
            ("numbers", free("Numbers in place of those of the reference.", words("A number, in quotes."))),
            (
                "answers",
                json!({
                    "description": "Each quantity with its value.",
                    "type": "object",
                    "minProperties": 1,
                    "additionalProperties": words("A number or formula, or a rounded decimal."),
                }),
            ),
        ],
        &["answers"],
    )
}

fn reference() -> Json {
    free(
        "One set of numbers for which the answers are known, one for each parameter. `erratum` says what was wrong in the \
         exercise that the question mirrors.",
        words("A number, in quotes."),
    )
}

fn part() -> Json {
    table(
        "One thing asked.",
        vec![
            ("ask", words("The words of the part; {result} stands for what is to be shown.")),
            ("answers", several("answer", "What is to be found, in the order asked.")),
            ("marks", several("mark", "The marks, in the order in which they are earned.")),
        ],
        &["ask", "answers", "marks"],
    )
}

fn answer() -> Json {
    let kinds = Kind::IN_BANK.map(Kind::name);
    let letter = json!({"type": "string", "pattern": NAME});
    table(
        "One answer.",
        vec![
            ("name", words("What it is, in words: speed of *A*. Each answer of a part has a name of its own.")),
            (
                "find",
                json!({
                    "description": "The quantity to find, such as A.after.speed; of a vector its two components; or a letter \
                                    among the scene's unknowns.",
                    "anyOf": [quantity(), list_of(quantity()), letter],
                }),
            ),
            (
                "kind",
                json!({
                    "description": "What sort of answer it is, where that does not follow from what is found.", "enum": kinds,
                }),
            ),
            (
                "accept",
                json!({
                    "description": "How near an answer must be; the exact value is accepted under every rule.",
                    "anyOf": [
                        {"enum": ["exact", "awrt 3sf", "awrt 2sf", "3sf", "2dp", "1dp", "nearest 1", "nearest degree"]},
                        {"type": "string", "pattern": ACCEPT},
                    ],
                }),
            ),
            ("phrase", words("Words that complete a direction, such as: to the line of centres.")),
            ("show", words("For 'show that': the left side of what is to be shown, such as tan(beta).")),
        ],
        &["name", "find"],
    )
}

fn mark() -> Json {
    table(
        "One mark.",
        vec![
            (
                "code",
                json!({
                    "description": "B1 stands alone; M1 is for method; A1 for accuracy, after its M1; dM1 needs earlier method \
                                    marks; A1ft follows through; A1* is for what is to be shown.",
                    "enum": Code::ALL.map(Code::name),
                }),
            ),
            (
                "for",
                json!({
                    "description": "The step that earns it, such as momentum or speed A, or what is found, such as A.after.speed.",
                    "anyOf": [one_of(&steps()), of_later(), of_two(), {"type": "string", "pattern": NAME}],
                }),
            ),
            ("text", words("What earns it, if not in the usual words.")),
            ("note", words("What the marker condones or demands, if not as usual.")),
            (
                "depends",
                texts(
                    "The marks without which it is not given, such as M1a and M1b: the first and second M1 of the part.",
                ),
            ),
        ],
        &["code", "for"],
    )
}

/// A quantity by its name, of the first impact or of a later one.
fn quantity() -> Json {
    either(&[one_of(&quantities()), of_later()])
}

/// `second.B.after.speed`.
fn of_later() -> Json {
    json!({"type": "string", "pattern": format!("^({})\\.[A-Za-z_.]+$", LATER.join("|"))})
}

/// Two quantities that a mark is for.
fn of_two() -> Json {
    json!({"type": "string", "pattern": "^[A-Za-z_.]+ and [A-Za-z_.]+$"})
}

fn quantities() -> Vec<String> {
    Quantity::all().iter().map(Quantity::to_string).collect()
}

/// Everything that a mark can be for: laws, laws with a sphere, conditions, quantities.
fn steps() -> Vec<String> {
    let mut steps = Vec::new();
    for name in EarnedFor::names() {
        steps.push(name.to_owned());
        let spheres = Sphere::BOTH.map(|sphere| format!("{name} {}", sphere.name()));
        steps.extend(spheres.into_iter().filter(|step| EarnedFor::read(step, &[]).is_some()));
    }
    steps.extend(quantities());
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bank::read_question;
    use crate::diagnostic::Source;

    /// A question in which an unknown key can be put into each table.
    const QUESTION: &str = "TOP\n[style.exact]\nSTYLE\n[scene]\nmasses = { PAIR }\nbefore = { A = { VELOCITY } }\nSCENE\n\
                            [[part]]\nPART\nanswers = [{ ANSWER }]\nmarks = [{ MARK }]\n[reference]\n[[test]]\nTEST\n";

    /// The keys that the reader asks a table for: those that it names beside one that it does not know.
    fn asked_for(place: &str) -> Vec<String> {
        let mut text = QUESTION.to_owned();
        for other in ["TOP", "STYLE", "SCENE", "PAIR", "VELOCITY", "PART", "ANSWER", "MARK", "TEST"] {
            text = text.replace(other, if other == place { "qqqqqqq = '1'" } else { "" });
        }
        let faults = read_question("q", &Source::new("q.toml", text.as_str())).unwrap_err();
        let fault = faults.iter().find(|fault| fault.message == "unknown key `qqqqqqq`").unwrap();
        let mut keys: Vec<String> = fault.label.split('`').skip(1).step_by(2).map(str::to_owned).collect();
        keys.sort();
        keys
    }

    #[test]
    fn the_schema_has_the_keys_that_the_reader_asks_for() {
        let schema = question_schema();
        let definitions = &schema["definitions"];
        let tables = [
            ("TOP", &schema),
            ("STYLE", &definitions["style"]),
            ("SCENE", &definitions["scene"]),
            ("PAIR", &definitions["scene"]["properties"]["masses"]),
            ("VELOCITY", &definitions["velocity"]["anyOf"][1]),
            ("PART", &definitions["part"]),
            ("ANSWER", &definitions["answer"]),
            ("MARK", &definitions["mark"]),
            ("TEST", &definitions["test"]),
        ];
        for (place, table) in tables {
            let mut keys: Vec<String> = table["properties"].as_object().unwrap().keys().cloned().collect();
            keys.sort();
            assert_eq!(keys, asked_for(place), "{place}: say in src/bank/schema.rs what each key is for");
            assert_eq!(table["additionalProperties"], false);
        }
    }

    #[test]
    fn every_key_says_what_it_is_for() {
        let schema = question_schema();
        let definitions = schema["definitions"].as_object().unwrap();
        for table in definitions.values().chain([&schema]) {
            for (key, value) in table["properties"].as_object().into_iter().flatten() {
                let said = match value["$ref"].as_str().and_then(|path| path.rsplit('/').next()) {
                    Some(name) => &definitions[name]["description"],
                    None => &value["description"],
                };
                assert!(said.as_str().is_some_and(|said| said.len() > 10), "{key}");
            }
        }
    }
}
