//! The filter inside an engine: Apache Spark marks what a run by itself marks, byte for byte.
//!
//! `.ci/run` puts pyspark into `target/spark`; it needs Java.

use std::env;
use std::fs;
use std::path::Path;
use std::process::Command;

use super::{carom, folder, table, text};

#[test]
#[ignore = "needs Java and Apache Spark, which `.ci/run` installs"]
fn spark_gives_the_marks_of_a_direct_run() {
    let folder = folder("spark");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    // In the order of their names, so that the pieces that Spark writes need no other order.
    let mut rows: Vec<String> = Vec::new();
    let mut reader = csv::Reader::from_reader(table(700).leak().as_bytes());
    for record in reader.records().map(Result::unwrap) {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let number: usize = record[0].trim_start_matches("S, ").parse().unwrap();
        let name = format!("S, {number:04} \"ö\"");
        writer.write_record(std::iter::once(&*name).chain(record.iter().skip(1))).unwrap();
        rows.push(text(&writer.into_inner().unwrap()));
    }
    let table = format!("student,question,part,blank,answer,working\n{}", rows.concat());
    fs::write(folder.join("answers.csv"), table).unwrap();
    let direct = carom(&folder, &["mark", "sheet/key.json", "answers.csv", "--feedback", "none"], b"");
    assert!(direct.status.success(), "{}", text(&direct.stderr));
    let run = Command::new(root.join("target/spark/bin/python"))
        .arg(root.join("examples/spark/mark.py"))
        .args(["sheet/key.json", "answers.csv", "by-spark"])
        .current_dir(&folder)
        .env("CAROM", env!("CARGO_BIN_EXE_carom"))
        .env("SPARK_LOCAL_IP", "127.0.0.1")
        // Few pieces, but more than one: rows of a student stay together.
        .env("PYSPARK_SUBMIT_ARGS", "--master local[2] --conf spark.ui.enabled=false --conf spark.sql.shuffle.partitions=5 --conf spark.sql.adaptive.enabled=false pyspark-shell")
        .output()
        .expect("pyspark in target/spark, as `.ci/run` puts it there");
    assert!(run.status.success(), "{}", text(&run.stderr));
    let mut pieces: Vec<_> =
        fs::read_dir(folder.join("by-spark")).unwrap().map(|entry| entry.unwrap().path()).collect();
    pieces.retain(|path| path.file_name().unwrap().to_string_lossy().starts_with("part-"));
    pieces.sort();
    assert!(pieces.len() > 1);
    let marks: String = pieces.iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    let direct = fs::read_to_string(folder.join("marks/marks.jsonl")).unwrap();
    assert!(marks == direct, "{} and {} bytes", marks.len(), direct.len());
    assert!(direct.lines().count() > 1000);
}
