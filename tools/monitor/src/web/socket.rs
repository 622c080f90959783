//! The WebSocket of a page.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::time::{Duration, Instant};

use axum::extract::ws::{CloseFrame, Message, WebSocket, WebSocketUpgrade};
use axum::extract::{Extension, State};
use axum::response::Response;
use bica::runner::STACK_BYTES;
use tokio::sync::{OwnedSemaphorePermit, watch};
use tokio::time::{interval, sleep, timeout};

use super::pending_connections::PendingConnection;
use super::queue::Queue;
use super::rate::Rate;
use super::{Enter, Shared};
use crate::pages::Outbox;
use crate::protocol::{Failed, FromPage, Request, ToPage};
use crate::sessions::Manager;

/// Largest message from a page, bytes.
const MAX_MESSAGE: usize = 64 << 10;
/// Largest message from a page that edits sources, bytes: a whole file may be in it.
const MAX_SOURCE_MESSAGE: usize = 4 << 20;
/// Longest time until a page proves that it may enter.
const ENTER_TIME: Duration = Duration::from_secs(5);
/// Delay of the answer to a wrong proof, so that tokens cannot be tried quickly.
const WRONG_PROOF: Duration = Duration::from_millis(500);
/// Longest time for sending a message to a page.
const SEND_TIME: Duration = Duration::from_secs(10);
/// Interval of pings. A page that answers none of three in a row is disconnected.
const PING: Duration = Duration::from_secs(5);
const SILENCE: Duration = Duration::from_secs(16);
/// Largest number of a page's requests that wait for the manager.
const MAX_WAITING: usize = 256;
/// Largest number of messages that are sent before the page's own messages are read again.
const AT_ONCE: usize = 16;

/// Codes of the WebSocket protocol.
const GOING_AWAY: u16 = 1001;
const POLICY: u16 = 1008;
const TRY_AGAIN: u16 = 1013;
/// Code of this server: the page may not enter.
const REFUSED: u16 = 4403;

/// Accepts a WebSocket.
pub(crate) async fn upgrade(
    State((shared, stop)): State<(Arc<Shared>, watch::Receiver<bool>)>,
    Extension(pending): Extension<Arc<PendingConnection>>,
    upgrade: WebSocketUpgrade,
) -> Response {
    let limit = if shared.manager.edits_sources() { MAX_SOURCE_MESSAGE } else { MAX_MESSAGE };
    upgrade.max_message_size(limit).max_frame_size(limit).on_upgrade(async move |mut socket| {
        let page = tokio::select! {
            page = enter(&mut socket, &shared) => page,
            () = pending.needed() => return,
        };
        match page {
            Ok(_page) => {
                pending.enter();
                run(socket, shared, stop).await;
            }
            Err(reason) => close(&mut socket, reason).await,
        }
    })
}

/// Waits for the first message of a page, checks it, and sends the secret of the origin. Returns the page's permit, or why it may
/// not enter.
async fn enter(socket: &mut WebSocket, shared: &Shared) -> Result<OwnedSemaphorePermit, (u16, &'static str)> {
    let silent = (REFUSED, "the page did not prove that it may enter");
    let Ok(Some(Ok(Message::Text(text)))) = timeout(ENTER_TIME, socket.recv()).await else { return Err(silent) };
    let proofs: Enter = serde_json::from_str(&text).map_err(|_| silent)?;
    let secret = match shared.access.enter(&proofs) {
        Ok(secret) => secret.to_owned(),
        Err(why) => {
            sleep(WRONG_PROOF).await;
            return Err((REFUSED, why));
        }
    };
    let page = Arc::clone(&shared.pages).try_acquire_owned().map_err(|_| (TRY_AGAIN, "too many pages are open"))?;
    let entered = serde_json::json!({ "type": "entered", "secret": secret });
    match send(socket, Message::Text(entered.to_string().into())).await {
        None => Ok(page),
        Some(reason) => Err(reason),
    }
}

/// Serves a page until it leaves, exceeds a limit, or the server stops.
async fn run(mut socket: WebSocket, shared: Arc<Shared>, mut stop: watch::Receiver<bool>) {
    let queue = Arc::new(Queue::default());
    let gone = Arc::new(AtomicBool::new(false));
    let Ok(requests) = handler(Arc::clone(&shared.manager), Arc::clone(&queue), Arc::clone(&gone)) else { return };
    let reason = tokio::select! {
        reason = exchange(&mut socket, &queue, &requests) => reason,
        _ = stop.changed() => Some((GOING_AWAY, "the server ends")),
    };
    // Of the requests that still wait only stops are executed. The manager removes the page when the channel is closed.
    gone.store(true, Ordering::Release);
    drop(requests);
    if let Some(reason) = reason {
        close(&mut socket, reason).await;
    }
}

async fn close(socket: &mut WebSocket, (code, reason): (u16, &'static str)) {
    let close = Message::Close(Some(CloseFrame { code, reason: reason.into() }));
    let _ = timeout(Duration::from_secs(1), socket.send(close)).await;
}

type Reason = Option<(u16, &'static str)>;

async fn exchange(socket: &mut WebSocket, queue: &Queue, requests: &Requests) -> Reason {
    let mut rate = Rate::new(Instant::now());
    let mut heard = Instant::now();
    let mut ping = interval(PING);
    let mut more = false;
    loop {
        tokio::select! {
            received = socket.recv() => {
                heard = Instant::now();
                let message = received?.ok()?;
                if !rate.allows(heard) {
                    return Some((POLICY, "too many messages"));
                }
                if let Some(reason) = take(message, queue, requests) {
                    return Some(reason);
                }
            }
            () = queue.changed() => {}
            () = std::future::ready(()), if more => {}
            _ = ping.tick() => {
                if heard.elapsed() > SILENCE {
                    return Some((POLICY, "the page is silent"));
                }
                if let Some(reason) = send(socket, Message::Ping(axum::body::Bytes::new())).await {
                    return Some(reason);
                }
            }
        }
        more = true;
        for _ in 0..AT_ONCE {
            let Some(message) = queue.pop() else {
                more = false;
                break;
            };
            if let Some(reason) = send(socket, message).await {
                return Some(reason);
            }
        }
        if queue.overflowed() {
            return Some((POLICY, "the page reads too slowly"));
        }
    }
}

/// Sends a message; returns the reason if the connection must end.
async fn send(socket: &mut WebSocket, message: Message) -> Reason {
    match timeout(SEND_TIME, socket.send(message)).await {
        Ok(Ok(())) => None,
        Ok(Err(_)) => Some((GOING_AWAY, "the page is gone")),
        Err(_) => Some((POLICY, "the page does not read")),
    }
}

/// Passes a message of the page to the manager; returns the reason if the connection must end.
fn take(message: Message, queue: &Queue, requests: &Requests) -> Reason {
    let text = match message {
        Message::Text(text) => text,
        Message::Binary(_) => return Some((POLICY, "pages send text")),
        Message::Close(_) => return Some((GOING_AWAY, "closed by the page")),
        Message::Ping(_) | Message::Pong(_) => return None,
    };
    match serde_json::from_str::<FromPage>(&text) {
        Ok(request) => (!requests.send(request)).then_some((POLICY, "too many requests wait")),
        Err(error) => {
            let id = serde_json::from_str::<serde_json::Value>(&text).ok().and_then(|value| value.get("id")?.as_u64());
            let failed = Failed {
                text: format!("this request is not understood: {error}"),
                help: "reload the page: it may be of another version than the server".to_owned(),
                entry: None,
                stale: false,
            };
            queue.state(ToPage::Answer { id: id.unwrap_or(0) as u32, result: None, error: Some(failed) });
            None
        }
    }
}

/// Channels of a page's requests to the manager. A stop does not wait for other requests.
struct Requests {
    stops: SyncSender<FromPage>,
    others: SyncSender<FromPage>,
}

impl Requests {
    /// Sends a request; returns whether there was room.
    fn send(&self, request: FromPage) -> bool {
        let sender = if matches!(request.request, Request::Stop {}) { &self.stops } else { &self.others };
        sender.try_send(request).is_ok()
    }
}

/// Starts the threads that pass a page's requests to the manager, which may wait for files and robots.
fn handler(manager: Arc<Manager>, queue: Arc<Queue>, gone: Arc<AtomicBool>) -> std::io::Result<Requests> {
    let ((others, requests), (stops, stop_requests)) = (sync_channel(MAX_WAITING), sync_channel(MAX_WAITING));
    std::thread::Builder::new().name("page".to_owned()).stack_size(STACK_BYTES).spawn(move || {
        let page = manager.attach(queue);
        let manager = &*manager;
        std::thread::scope(|scope| {
            scope.spawn(move || stop_requests.iter().for_each(|stop| manager.handle(page, stop)));
            forward(&requests, &gone, |request| manager.handle(page, request));
        });
        manager.detach(page);
    })?;
    Ok(Requests { stops, others })
}

/// Passes requests on until the page is gone; requests that still wait are dropped.
fn forward(requests: &Receiver<FromPage>, gone: &AtomicBool, mut handle: impl FnMut(FromPage)) {
    for request in requests {
        if gone.load(Ordering::Acquire) {
            return;
        }
        handle(request);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn requests_of_a_page_that_is_gone_are_dropped() {
        let (sender, requests) = sync_channel(8);
        for id in 1..=5 {
            sender.send(FromPage { id, session: None, request: Request::Recordings {} }).unwrap();
        }
        drop(sender);
        let gone = AtomicBool::new(false);
        let mut handled = Vec::new();
        forward(&requests, &gone, |request| {
            handled.push(request.id);
            gone.store(request.id == 2, Ordering::Release);
        });
        assert_eq!(handled, [1, 2]);
    }
}
