//! What a scene names in its conditions and unknowns: does it exist, and is it not given already?

use crate::expr::{Angles, Fault, Span, read};
use crate::mechanics::{Quantity, SceneFault, SceneText, Sphere, name_meant};

/// Names that mean nothing in conditions, and unknowns whose value is given: the faults of a scene that stands alone.
pub fn scene_names(scene: &SceneText) -> Vec<SceneFault> {
    let mut faults = given_unknowns(scene);
    let letters: Vec<String> = scene.symbols.keys().chain(&scene.unknowns).cloned().collect();
    let places = scene.conditions.iter().enumerate().map(|(place, text)| (format!("conditions[{place}]"), text));
    for (field, whole) in places.chain(scene.maximise.iter().map(|text| ("maximise".to_owned(), text))) {
        let Ok(expr) = read(whole, Angles::Radians) else { continue };
        for name in expr.names() {
            let text = name.text.as_str();
            if letters.contains(&name.text) || text.parse::<Quantity>().is_ok() {
                continue;
            }
            let label = "expected a quantity, or a letter of `symbols`";
            let unknown = || Fault::new(format!("unknown name `{text}`"), name.span, label);
            let fault = match Fault::unknown_function(whole, name.span) {
                Some(fault) => fault,
                None => unknown().try_this(name_meant(text, &letters).1),
            };
            faults.push(SceneFault { field: field.clone(), fault, is_of_the_form: true });
        }
    }
    faults
}

/// Unknowns to which the scene gives a value: `e`, or a mass.
pub fn given_unknowns(scene: &SceneText) -> Vec<SceneFault> {
    let given = |unknown: &str| match unknown {
        "e" => scene.e.as_ref(),
        mass => [(Sphere::A, &scene.masses.a), (Sphere::B, &scene.masses.b)]
            .into_iter()
            .find(|(sphere, _)| mass == format!("{}.mass", sphere.name()))
            .and_then(|(_, mass)| mass.as_ref()),
    };
    let faults = scene.unknowns.iter().enumerate().filter_map(|(place, unknown)| {
        // What stands for itself is not given.
        let value = given(unknown).filter(|value| *value != unknown)?;
        let message = format!("`{unknown}` is given, and cannot be found");
        let fault = Fault::new(message, Span::default(), format!("the scene gives it the value `{value}`")).try_this(
            match unknown.as_str() {
                "e" if !scene.then.is_empty() => {
                    "give the letter of the later impact another name: `e` is the coefficient of the first"
                }
                _ => "take the name out of `unknowns`, or the value out of the scene",
            },
        );
        Some(SceneFault { field: format!("unknowns[{place}]"), fault, is_of_the_form: true })
    });
    faults.collect()
}
