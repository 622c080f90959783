//! The cart that `bica new` writes.

use std::process::ExitCode;

#[expect(unreachable_pub, reason = "in its own crate it is the library")]
#[path = "../tools/app/template/cart/lib.rs"]
mod cart;

fn main() -> ExitCode {
    cart::app().run()
}
