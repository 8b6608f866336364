//! Lists the question bank and the templates for the binary, so that a new question or a new format is
//! a file in its folder and nothing else.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("cargo sets the manifest's folder"));
    let out = PathBuf::from(env::var("OUT_DIR").expect("cargo sets the output folder"));
    for (folder, list) in [("question_bank", "questions.rs"), ("templates", "templates.rs")] {
        println!("cargo::rerun-if-changed={folder}");
        let mut files = Vec::new();
        collect(&root.join(folder), &mut files)?;
        let mut named: Vec<(String, PathBuf)> = files
            .into_iter()
            .filter(|path| path.extension().is_some_and(|extension| extension != "md"))
            .map(|path| {
                let name = path.strip_prefix(root.join(folder)).expect("collected below the folder");
                let parts: Vec<_> = name.components().map(|part| part.as_os_str().to_string_lossy()).collect();
                (parts.join("/"), path)
            })
            .collect();
        named.sort();
        let entry =
            |(name, path): &(String, PathBuf)| format!("    ({name:?}, include_str!({:?})),\n", path.to_string_lossy());
        let entries: String = named.iter().map(entry).collect();
        fs::write(out.join(list), format!("&[\n{entries}]\n"))?;
    }
    Ok(())
}

/// Every file below a folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() { collect(&path, files)? } else { files.push(path) }
    }
    Ok(())
}
