//! `carom schema`: what may stand in a file, as JSON Schema.

use clap::{Args, ValueEnum};

use super::failure::Failure;
use super::output::print;
use crate::bank::question_schema;

const AFTER: &str = "Examples:
  carom schema question > my-bank/question.schema.json    for an editor
  carom schema key                                        what `key.json` holds

An editor that knows TOML (VS Code with 'Even Better TOML', or anything with taplo) completes
keys, shows what each is for and underlines mistakes in a question whose first line names the
schema: `#:schema question.schema.json`.";

/// Print what may stand in a file, for editors and other programs
///
/// As JSON Schema: of a question of a bank, or of one of the files that carom exchanges with other programs.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct SchemaArguments {
    /// Of what
    #[arg(value_name = "FORMAT")]
    format: SchemaOf,
}

/// What has a schema.
#[derive(Clone, Copy, Debug, ValueEnum)]
enum SchemaOf {
    /// A question file of a bank
    Question,
    /// A scene, as `carom solve` reads it
    Scene,
    /// What `carom solve --json` prints
    Solution,
    /// The `key.json` of a sheet
    Key,
    /// The `lock.json` of a class
    Lock,
    /// What `carom compare --json` prints
    Verdict,
    /// A line of `marks.jsonl`
    Marks,
}

/// Prints the schema.
pub fn run(arguments: &SchemaArguments) -> Result<(), Failure> {
    match arguments.format {
        SchemaOf::Question => print(&of_questions()),
        SchemaOf::Scene => print(include_str!("../../docs/schema/scene.schema.json")),
        SchemaOf::Solution => print(include_str!("../../docs/schema/solution.schema.json")),
        SchemaOf::Key => print(include_str!("../../docs/schema/key.schema.json")),
        SchemaOf::Lock => print(include_str!("../../docs/schema/lock.schema.json")),
        SchemaOf::Verdict => print(include_str!("../../docs/schema/verdict.schema.json")),
        SchemaOf::Marks => print(include_str!("../../docs/schema/marks.schema.json")),
    }
}

/// The schema of question files as a file.
pub fn of_questions() -> String {
    format!("{:#}\n", question_schema())
}
