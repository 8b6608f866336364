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
    // In an empty folder of a format templates may be written while a preview is watched; an empty one of templates is none.
    match fs::read_dir(folder).is_ok_and(|mut all| all.next().is_none()) {
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
    #[test]
    fn an_empty_folder_of_a_format_is_one_to_write_templates_in() {
        let folder = std::env::temp_dir().join(format!("carom-templates-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        assert!(own_templates(Some(&folder)).is_err());
        fs::create_dir_all(folder.join("html")).unwrap();
        assert_eq!(own_templates(Some(&folder)).map_err(|_| ()).map(|files| files.len()), Ok(0));
        fs::remove_dir_all(&folder).unwrap();
    }
}
