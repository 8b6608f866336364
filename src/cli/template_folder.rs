//! A teacher's own folder of templates, read from the disk: what `--templates DIR` names.

use std::fs;
use std::io;
use std::path::Path;

use super::failure::Failure;
use crate::diagnostic::why_unread;
use crate::render::TemplateFile;

/// The templates in the folder that the arguments name; none if they name none.
pub fn own_templates(folder: Option<&Path>) -> Result<Vec<TemplateFile>, Failure> {
    let Some(folder) = folder else { return Ok(Vec::new()) };
    let shown = folder.display();
    let files = read_templates(folder).map_err(|error| {
        let message = format!("the templates in `{shown}` cannot be read: {error}");
        Failure::with_help(message, "name a folder of templates; `templates/README.md` says what stands in one")
    })?;
    // A folder of a format that is empty yet is where templates are to be written while a preview is watched.
    let has_formats =
        || fs::read_dir(folder).is_ok_and(|mut all| all.any(|entry| entry.is_ok_and(|entry| entry.path().is_dir())));
    match files.is_empty() && !has_formats() {
        false => Ok(files),
        true => Err(Failure::with_help(
            format!("no templates in `{shown}`"),
            format!(
                "each stands in a folder named after its format, as `{shown}/html/style.css` would: see `templates/README.md`"
            ),
        )),
    }
}

/// Every file below a folder, in the order of their paths; hidden ones are left alone.
///
/// The fault names the file that could not be read.
pub fn read_templates(folder: &Path) -> io::Result<Vec<TemplateFile>> {
    let mut files = Vec::new();
    collect(folder, "", &mut files)?;
    files.sort_by(|one, other| one.path.cmp(&other.path));
    Ok(files)
}

fn collect(folder: &Path, prefix: &str, files: &mut Vec<TemplateFile>) -> io::Result<()> {
    let named = |fault: io::Error, path: &Path| {
        io::Error::new(fault.kind(), format!("`{}`: {}", path.display(), why_unread(&fault)))
    };
    for entry in fs::read_dir(folder).map_err(|fault| named(fault, folder))? {
        let path = entry.map_err(|fault| named(fault, folder))?.path();
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        if name.starts_with('.') {
            continue;
        }
        if path.is_dir() {
            collect(&path, &format!("{prefix}{name}/"), files)?;
        } else {
            let contents = fs::read_to_string(&path).map_err(|fault| named(fault, &path))?;
            let place = path.display().to_string();
            files.push(TemplateFile { path: format!("{prefix}{name}"), place, contents });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn carom_knows_the_files_of_its_own_templates() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("templates");
        let files = read_templates(&folder).unwrap();
        let paths: Vec<&str> = files.iter().map(|file| file.path.as_str()).collect();
        assert!(paths.contains(&"latex/format.toml") && paths.contains(&"README.md"), "{paths:?}");
        assert!(paths.is_sorted());
        let missing = read_templates(&folder.join("none")).unwrap_err().to_string();
        assert!(missing.contains("none"), "{missing}");
    }
}
