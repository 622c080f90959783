//! Connections and routes.

use std::net::TcpListener;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use axum::Router;
use axum::extract::{DefaultBodyLimit, Path, State};
use axum::http::{StatusCode, header};
use axum::middleware::from_fn_with_state;
use axum::response::{IntoResponse, Response};
use axum::routing::{get, post};
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::TcpStream;
use tokio::sync::watch;

use super::{Shared, assets, guard, socket};

/// Largest number of open TCP connections.
const MAX_CONNECTIONS: usize = 128;
/// Largest number of pages.
pub(crate) const MAX_PAGES: usize = 32;
/// Longest time until the head of a request is complete.
const HEAD_TIME: Duration = Duration::from_secs(5);
/// Longest token that a page sends, bytes.
const MAX_TOKEN: usize = 1024;
/// Delay of the answer to a wrong token, so that tokens cannot be tried quickly.
const WRONG_TOKEN: Duration = Duration::from_millis(500);

/// A limited number of things that exist at the same time.
#[derive(Clone)]
pub(crate) struct Counter {
    count: Arc<AtomicUsize>,
    limit: usize,
}

/// One of the counted things; it is counted until it is dropped.
pub(crate) struct Counted(Arc<AtomicUsize>);

impl Counter {
    pub(crate) fn new(limit: usize) -> Self {
        Self { count: Arc::default(), limit }
    }

    /// Counts one more, if the limit is not reached.
    pub(crate) fn take(&self) -> Option<Counted> {
        let more = |count| (count < self.limit).then_some(count + 1);
        self.count.fetch_update(Ordering::Relaxed, Ordering::Relaxed, more).ok()?;
        Some(Counted(Arc::clone(&self.count)))
    }
}

impl Drop for Counted {
    fn drop(&mut self) {
        self.0.fetch_sub(1, Ordering::Relaxed);
    }
}

/// Accepts connections until `stop` changes.
pub(crate) async fn serve(listener: TcpListener, shared: Arc<Shared>, mut stop: watch::Receiver<bool>) {
    let Ok(listener) = tokio::net::TcpListener::from_std(listener) else { return };
    let routes = routes(&shared, &stop);
    let connections = Counter::new(MAX_CONNECTIONS);
    loop {
        let accepted = tokio::select! {
            accepted = listener.accept() => accepted,
            _ = stop.changed() => return,
        };
        match accepted {
            // A connection above the limit is closed at once.
            Ok((stream, _)) => {
                if let Some(counted) = connections.take() {
                    tokio::spawn(connection(stream, routes.clone(), counted));
                }
            }
            // Too many open files, or a connection that was cut before it was accepted.
            Err(_) => tokio::time::sleep(Duration::from_millis(20)).await,
        }
    }
}

async fn connection(stream: TcpStream, routes: Router, counted: Counted) {
    let _ = stream.set_nodelay(true);
    let service = TowerToHyperService::new(routes);
    let served = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(HEAD_TIME)
        .max_buf_size(64 << 10)
        .serve_connection(TokioIo::new(stream), service)
        .with_upgrades()
        .await;
    // What a client did wrong concerns nobody else.
    drop((served, counted));
}

fn routes(shared: &Arc<Shared>, stop: &watch::Receiver<bool>) -> Router {
    Router::new()
        .route("/", get(|| async { file("index.html") }))
        .route("/enter", post(enter))
        .route("/socket", get(socket::upgrade))
        .route("/{*name}", get(|Path(name): Path<String>| async move { file(&name) }))
        .layer(DefaultBodyLimit::max(MAX_TOKEN))
        .layer(from_fn_with_state(Arc::clone(shared), guard::guard))
        .with_state((Arc::clone(shared), stop.clone()))
}

pub(crate) type Context = State<(Arc<Shared>, watch::Receiver<bool>)>;

fn file(name: &str) -> Response {
    match assets::file(name) {
        Some((bytes, media)) => ([(header::CONTENT_TYPE, media)], bytes.into_owned()).into_response(),
        None => (StatusCode::NOT_FOUND, "the page has no such file").into_response(),
    }
}

/// Lets a page in that knows the token.
async fn enter(State((shared, _)): Context, token: String) -> Response {
    if !shared.access.has_token() {
        return (StatusCode::FORBIDDEN, "this server has no token: open the address that it printed").into_response();
    }
    if !shared.access.is_token(token.trim()) {
        tokio::time::sleep(WRONG_TOKEN).await;
        return (StatusCode::FORBIDDEN, "this is not the token in the server's token file").into_response();
    }
    (StatusCode::NO_CONTENT, [(header::SET_COOKIE, shared.access.set_cookie())]).into_response()
}
