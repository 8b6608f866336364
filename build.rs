//! Lists the question bank and the templates for the binary, so that a new question or a new format is
//! a file in its folder and nothing else; and gives the source a number, by which what one build found is told from
//! what another did.

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
    println!("cargo::rustc-env=CAROM_SOURCE={}", source(&root)?);
    Ok(())
}

/// A number over every file from which the binary is made, and the versions of all that it is made with: FNV-1a.
fn source(root: &Path) -> io::Result<String> {
    let mut files = vec![root.join("Cargo.lock"), root.join("Cargo.toml"), root.join("build.rs")];
    collect(&root.join("src"), &mut files)?;
    files.sort();
    let mut hash: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    for name in ["Cargo.lock", "Cargo.toml", "build.rs", "src"] {
        println!("cargo::rerun-if-changed={name}");
    }
    for path in files {
        let name = path.strip_prefix(root).expect("collected below the root").to_string_lossy().into_owned();
        // A package made from the repository may come without the lock.
        let text = fs::read(&path).or_else(|fault| if path.is_file() { Err(fault) } else { Ok(Vec::new()) })?;
        for byte in name.into_bytes().into_iter().chain([0]).chain(text).chain([0]) {
            hash = (hash ^ u128::from(byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b);
        }
    }
    Ok(format!("{hash:032x}"))
}

/// Every file below a folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() { collect(&path, files)? } else { files.push(path) }
    }
    Ok(())
}
