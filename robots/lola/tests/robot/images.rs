//! Images over their own socket.

use std::io::Write;
use std::os::unix::net::UnixListener;
use std::sync::atomic::{AtomicU32, Ordering};

use bica_lola::LolaWorld;
use bica_lola::camera::Origin;
use bica_motion::model::NAO;
use bica_motion::robot::{CameraId, Command};

use crate::stand_in::{RISE, StandIn, frame};

/// Images that the programs of these tests have received: their count, and the brightness of the last one.
static SEEN: [AtomicU32; 2] = [AtomicU32::new(0), AtomicU32::new(0)];

/// A program that selects the bottom camera, and checks its images.
fn look(_cycle: u32, world: &mut LolaWorld) -> Command {
    if let Some(image) = world.sense().image {
        assert_eq!((image.camera, image.width, image.height), (CameraId::Bottom, 320, 240));
        SEEN[0].fetch_add(1, Ordering::Relaxed);
        SEEN[1].store(u32::from(image.yuyv[0]), Ordering::Relaxed);
    }
    Command { camera: CameraId::Bottom, ..Command::new(NAO.stand, 0.8) }
}

#[test]
fn images_of_the_selected_camera_arrive_once() {
    let mut robot = StandIn::start_with(look, |options| {
        options.images = Some(Origin::Socket(options.socket.with_file_name("frames")));
    });
    robot.cycles(RISE);
    let path = robot.folder().join("frames");
    for round in 0..2_u32 {
        // The socket is there late, and is closed between the rounds.
        let listener = UnixListener::bind(&path).expect("a socket");
        let (mut frames, _) = listener.accept().expect("the driver connects");
        for image in 0..20 {
            let number = RISE as u32 + 40 * round + 2 * image;
            for camera in [CameraId::Top, CameraId::Bottom] {
                frames.write_all(&frame(camera, number, 10 + image as u8)).expect("the driver reads");
            }
            // A robot in step gets an answer with all images that it has sent before.
            robot.cycles(1);
            let seen = [0, 1].map(|index: usize| SEEN[index].load(Ordering::Relaxed));
            assert_eq!(seen, [20 * round + image + 1, 10 + image]);
            robot.cycles(1);
        }
        drop((frames, listener));
        std::fs::remove_file(&path).expect("the socket");
    }
}
