//! A page that connects while sessions change.

use std::sync::{Arc, Mutex};

use bica_monitor::protocol::{FromPage, Open, Request, ToPage};
use bica_monitor::sessions::{Frame, Key, Outbox};
use serde_json::{Value, json};

use crate::page::Bench;

/// A page during whose `hello` the session is closed.
struct Closing(Arc<Bench>, Mutex<Vec<Value>>);

impl Outbox for Closing {
    fn state(&self, message: ToPage) {
        if matches!(message, ToPage::Hello { .. }) {
            self.0.manager.handle(0, FromPage { id: 1, session: Some(1), request: Request::Close {} });
        }
        self.1.lock().unwrap().push(serde_json::to_value(message).unwrap());
    }

    fn binary(&self, _frame: Arc<[u8]>) {}

    fn data(&self, _key: Key, _frame: Frame) {}
}

#[test]
fn session_closed_while_a_page_comes_is_closed() {
    let bench = Bench::new();
    bench.manager.open(Open::Robot { address: "tcp://127.0.0.1:1".to_owned() }).unwrap();
    let page = Arc::new(Closing(Arc::clone(&bench), Mutex::default()));
    let id = bench.manager.attach(Arc::clone(&page) as Arc<dyn Outbox>);
    // The manager and the page own each other; this ends the cycle.
    bench.manager.detach(id);
    let got = page.1.lock().unwrap();
    assert_eq!(got[0]["sessions"].as_array().unwrap().len(), 1);
    assert_eq!(got.last().unwrap(), &json!({ "type": "closed", "session": 1 }));
}
