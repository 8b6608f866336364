//! `carom study`: methods compared, speed against accuracy, and where each of them fails.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};

use super::failure::Failure;
use super::output::{count, say};
use super::text_file;
use super::write::{OutputFile, make_folder, remove, write_all};
use crate::study::{Cost, Effort, Plan, Study, length, read_times, run as carry_out};

const AFTER: &str = "Examples:
  carom study --quick                    a quick look; then open study/methods.html
  carom study                            the same with times that vary less
  carom study --peers peers.csv          with other programs beside, timed by benches/peers.py
  carom study --times study/methods/times.csv   charts anew from times of before";

/// Compare methods: what an impact costs, how wrong it is, where formulas fail
///
/// Solves many scenes by every method there is, the good, the quick and the bad, and compares them with exact numbers.
/// Writes charts (SVG), tables (CSV, JSON) and one page that explains them to a teacher.
/// Exits with 1 if anything that the page claims is not so.
#[derive(Args)]
#[command(after_help = AFTER)]
pub struct StudyArguments {
    /// Look at the clock for a few seconds only
    #[arg(long)]
    quick: bool,
    /// The folder for the files
    #[arg(long, value_name = "DIR", default_value = "study")]
    out: PathBuf,
    /// Times of other programs, a table as benches/peers.py writes it
    #[arg(long, value_name = "CSV")]
    peers: Option<PathBuf>,
    /// Times of an earlier study, in place of new ones
    #[arg(long, value_name = "CSV", conflicts_with_all = ["peers", "quick"])]
    times: Option<PathBuf>,
}

/// Carries a study out and writes its files.
pub fn run(arguments: &StudyArguments) -> Result<(), Failure> {
    let plan = Plan {
        effort: if arguments.quick { Effort::QUICK } else { Effort::THOROUGH },
        times: arguments.times.as_deref().map(table).transpose()?,
        peers: arguments.peers.as_deref().map(table).transpose()?.unwrap_or_default(),
    };
    // Minutes of work are not to end with a folder that cannot be made.
    let made = make_folder(&arguments.out)?;
    let bar = ProgressBar::new(length(&plan));
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {percent}%, {msg}") {
        bar.set_style(style);
    }
    let begun = Instant::now();
    let now = || begun.elapsed().as_nanos() as u64;
    let study = carry_out(&plan, &now, &mut |what| {
        bar.set_message(what);
        bar.inc(1);
    });
    bar.finish_and_clear();
    let written = study.and_then(|study| Ok((study.files()?, study))).map_err(Failure::said);
    let written = written.and_then(|(files, study)| {
        let files: Vec<OutputFile> = files.into_iter().map(OutputFile::from).collect();
        Ok((study, write_all(&arguments.out, &files)?))
    });
    let (study, written) = written.inspect_err(|_| remove(&made))?;
    told(&study, &arguments.out, written.len())
}

/// What came of it, in two lines.
fn told(study: &Study, folder: &Path, files: usize) -> Result<(), Failure> {
    let claims = study.claims.claim.len() + study.claims.count.len();
    let page = folder.join("methods.html");
    say(&format!("{} in `{}`; open `{}` in a browser", count(files, "file"), folder.display(), page.display()));
    if study.broken.is_empty() {
        say(&format!("{} hold, each in both directions", count(claims, "claim")));
        return Ok(());
    }
    let broken =
        format!("{} of {claims} do not hold:\n  {}", count(study.broken.len(), "claim"), study.broken.join("\n  "));
    Err(Failure::with_help(broken, "the claims are in src/study/claims.toml: mend what has changed, or say what is so"))
}

/// A table of times from the disk.
fn table(path: &Path) -> Result<Vec<Cost>, Failure> {
    Ok(read_times(&text_file::text(path)?)?)
}
