//! Speech by `espeak-ng`, and sound output of this computer by `paplay`. Both programs are optional.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};

use bica_app::Failure;

use crate::body::Sounding;
use crate::script::{Clip, Script};

/// Words per minute: slow speech, our choice. The default of the program is 175.
const SPEED: &str = "130";
/// Full volume in the units of `paplay`.
const FULL: f32 = 65_536.0;

/// Replaces each text of a session by a WAV file in a folder; a file that exists there is used again.
///
/// # Errors
/// If the folder cannot be created, or `program` (such as `espeak-ng`) cannot be started or fails for a text. The
/// remaining texts stay texts.
pub(crate) fn speak(script: &mut Script, folder: &Path, program: &str) -> Result<(), Failure> {
    let failed = |error| Failure::of_path("create", folder, &error, "give a folder that can be written");
    fs::create_dir_all(folder).map_err(failed)?;
    for clip in &mut script.clips {
        let Clip::Text { text, language } = clip else { continue };
        let mut hash = DefaultHasher::new();
        (&text, SPEED).hash(&mut hash);
        let file = folder.join(format!("{language}-{:016x}.wav", hash.finish()));
        if !file.exists() {
            let mut command = Command::new(program);
            command.args(["-v", language, "-s", SPEED, "-w"]).arg(&file).arg("--").arg(text).stdin(Stdio::null());
            let failed =
                |why: &str| Failure::new(format!("`{program}` cannot speak: {why}"), "`apt install espeak-ng`");
            let made = command.output().map_err(|error| failed(&error.to_string()))?;
            if !made.status.success() || !file.exists() {
                return Err(failed(String::from_utf8_lossy(&made.stderr).trim()));
            }
        }
        // The path does not depend on the folder of the session.
        *clip = Clip::File(fs::canonicalize(&file).unwrap_or(file));
    }
    Ok(())
}

/// Plays the clips of a session.
#[derive(Debug)]
pub(crate) struct Player {
    program: String,
    /// File of each clip; `None` for a text.
    files: Vec<Option<PathBuf>>,
    /// Clips of speech and of music that are played, and the processes that play them.
    channels: [(Option<u16>, Option<Child>); 2],
}

impl Player {
    /// Creates a player for the clips of a session, whose files are relative to `folder`. `program` is called like `paplay`.
    pub(crate) fn new(script: &Script, folder: &Path, program: &str) -> Self {
        let file = |clip: &Clip| if let Clip::File(file) = clip { Some(folder.join(file)) } else { None };
        let files = script.clips.iter().map(file).collect();
        Self { program: program.to_owned(), files, channels: Default::default() }
    }

    /// Starts and ends clips according to `sound`. A new volume applies from the next clip on.
    pub(crate) fn play(&mut self, sound: Sounding) -> io::Result<()> {
        for ((before, child), clip) in self.channels.iter_mut().zip([sound.speech, sound.music]) {
            if std::mem::replace(before, clip) == clip {
                continue;
            }
            end(child);
            if let Some(Some(file)) = clip.and_then(|clip| self.files.get(usize::from(clip))) {
                let volume = format!("--volume={:.0}", FULL * sound.volume);
                *child = Some(Command::new(&self.program).arg(volume).arg(file).stderr(Stdio::null()).spawn()?);
            }
        }
        Ok(())
    }
}

impl Drop for Player {
    fn drop(&mut self) {
        self.channels.iter_mut().for_each(|(_, child)| end(child));
    }
}

/// Ends a process that plays a clip.
fn end(child: &mut Option<Child>) {
    if let Some(mut child) = child.take() {
        let _ = child.kill();
        let _ = child.wait();
    }
}

#[cfg(test)]
mod tests {
    use bica_test_data::process::Folder;

    use super::*;
    use crate::robot::Order;

    #[test]
    fn texts_are_spoken_in_their_language() {
        let mut script = Script::parse("say \"- Hello.\"\nsay \"Guten Morgen, wie geht es?\" in de").expect("a script");
        let (folder, silent) = (Folder::new("speech"), script.clone());
        assert!(speak(&mut script, folder.path(), "no-such-program").is_err() && script == silent);
        let spoken = speak(&mut script, folder.path(), "espeak-ng");
        let orders = script.orders(Path::new("."));
        if let Err(failure) = spoken {
            println!("skipped: {failure:?}");
            return;
        }
        assert!(matches!(&script.clips[1], Clip::File(file) if file.to_string_lossy().contains("/de-")));
        let [Order::Clip(hello), Order::Clip(morning), ..] = orders[..] else { panic!("{orders:?}") };
        assert!(hello > 0.5 && morning > hello + 0.5, "{hello} {morning}");
    }

    #[cfg(unix)]
    #[test]
    fn a_clip_is_played_once_and_ends_at_a_stop() {
        use std::os::unix::fs::PermissionsExt;
        let folder = Folder::new("player");
        let (program, log) = (folder.file("play"), folder.file("play.log"));
        fs::write(&program, "#!/bin/sh\necho \"$@\" >> \"$0.log\"\nexec sleep 600\n").expect("a program");
        fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).expect("it can be run");
        let script = Script::parse("music \"a.wav\"").expect("a right script");
        let mut player = Player::new(&script, folder.path(), &program);
        let music = Sounding { music: Some(0), volume: 0.5, ..Sounding::default() };
        (0..3).for_each(|_| player.play(music).expect("it plays"));
        let log = std::iter::repeat_with(|| fs::read_to_string(&log).unwrap_or_default());
        let log = log.inspect(|_| std::thread::yield_now()).find(|log| log.ends_with('\n')).expect("a line");
        assert_eq!(log, format!("--volume=32768 {}\n", folder.file("a.wav")));
        let child = player.channels[1].1.as_ref().expect("a program").id();
        player.play(Sounding::default()).expect("it ends");
        assert!(!Path::new(&format!("/proc/{child}")).exists() && player.channels[1].1.is_none());
    }
}
