//! The files that a session uses: taken out of an opened archive, and put into one that is saved or kept.

use crate::model::Model;
use crate::session::file::{Archive, Attachment};
use crate::session::{History, Session};
use std::sync::Arc;

impl Model {
    /// A model of the archive's session, with its files at hand.
    pub fn of_archive(archive: &mut Archive) -> Self {
        let mut files = Self::new(Session::default());
        files.keep_files(archive);
        Self::with_files(archive.session().clone(), files.surface_files)
    }

    /// Keeps the files of the archive's surfaces. A name that a different file has already is changed, in all steps.
    pub fn keep_files(&mut self, archive: &mut Archive) {
        let mut names: Vec<(String, String)> = Vec::new();
        for Attachment { name, bytes } in &mut archive.surfaces {
            let kept = self.surface_files.keep(name, Arc::clone(bytes));
            if kept.name != *name {
                names.push((std::mem::replace(name, kept.name.clone()), kept.name));
            }
        }
        if !names.is_empty() {
            let renamed =
                |name: &str| names.iter().find(|(old, _)| old == name).map_or(name, |(_, new)| new.as_str()).to_owned();
            archive.history.rename_surface_files(&renamed);
        }
    }

    /// The history with the files of surfaces that one of its steps uses, as far as they are at hand.
    pub fn archive(&self, history: History, picture: Option<Attachment>) -> Archive {
        let steps = history.past().iter().chain([history.now()]).chain(history.future());
        let used: Vec<&str> = steps.flat_map(Session::surface_files).collect();
        let files = self.surface_files.used(|name| used.contains(&name));
        let surfaces =
            files.map(|file| Attachment { name: file.name.clone(), bytes: Arc::clone(&file.bytes) }).collect();
        Archive { history, surfaces, picture }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::conformal::Side;
    use crate::session::{Command, SurfaceShape, SurfaceSpec};

    fn on_surface(name: &str) -> Session {
        let shape = SurfaceShape::File { name: name.into() };
        let surface = SurfaceSpec { shape, ..SurfaceSpec::default() };
        Session::with([Command::SetSurface { side: Side::Target, surface }])
    }

    fn attachment(name: &str, bytes: &[u8]) -> Attachment {
        Attachment { name: name.into(), bytes: Arc::new(bytes.to_vec()) }
    }

    #[test]
    fn a_file_of_a_known_name_is_renamed_in_all_steps() {
        let mut model = Model::new(Session::default());
        model.surface_files.keep("cow.obj", b"another".to_vec());
        let history = History::from_steps(vec![on_surface("cow.obj")], Session::default(), Vec::new());
        let mut archive = Archive { history, surfaces: vec![attachment("cow.obj", b"v")], picture: None };
        model.keep_files(&mut archive);
        assert_eq!(archive.history.past()[0].surface_files().collect::<Vec<_>>(), ["cow (2).obj"]);
        let again = model.archive(archive.history, None);
        assert_eq!(again.surfaces, [attachment("cow (2).obj", b"v")], "the other file is not of this session");
    }

    #[test]
    fn a_model_of_an_archive_asks_for_no_file() {
        let mut archive = Archive::from(on_surface("cow.obj"));
        archive.surfaces.push(attachment("cow.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        let model = Model::of_archive(&mut archive);
        assert!(model.surface_side(Side::Target).preparation.error.is_none());
        assert!(model.surface_side(Side::Target).preparation.awaits_file(), "it is being prepared");
    }
}
