//! Check of every request, before it is handled.

use std::sync::Arc;

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderName, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::{Shared, assets, headers};

/// Files that a browser may read before it has entered.
const PUBLIC: [&str; 2] = ["/enter.css", "/enter.js"];
const FETCH_SITE: HeaderName = HeaderName::from_static("sec-fetch-site");

/// Refuses or passes a request, and adds the headers of the response.
pub(crate) async fn guard(State(shared): State<Arc<Shared>>, request: Request, next: Next) -> Response {
    let mut response = match answer(&shared, &request) {
        None => next.run(request).await,
        Some(response) => response,
    };
    headers::add(response.headers_mut());
    response
}

/// Returns the answer to a request that is not passed on: a refusal, or the cookie for a key.
fn answer(shared: &Shared, request: &Request) -> Option<Response> {
    let headers = request.headers();
    let host = only(headers, &header::HOST).unwrap_or_default();
    if !shared.hosts.allows(host) {
        return Some(refuse("this server is not known under that name"));
    }
    // Browsers say where a request comes from; other programs do not.
    if !matches!(text(headers, &FETCH_SITE), None | Some("same-origin" | "none")) {
        return Some(refuse("requests of other sites are refused"));
    }
    let path = request.uri().path();
    let enters = path == "/enter" && request.method() == Method::POST;
    if request.method() != Method::GET && !enters {
        return Some((StatusCode::METHOD_NOT_ALLOWED, "only GET").into_response());
    }
    if (path == "/socket" || enters) && !has_origin(shared, headers, host) {
        return Some(refuse("pages of another origin are refused"));
    }
    if enters || PUBLIC.contains(&path) {
        return None;
    }
    if path == "/"
        && let Some(key) = request.uri().query().and_then(|query| query.strip_prefix("key="))
    {
        return Some(if shared.access.redeem(key) { welcome(shared) } else { ask() });
    }
    if is_known(shared, headers) { None } else { Some(ask()) }
}

/// A browser sends an origin with each WebSocket; a program without one needs the token.
fn has_origin(shared: &Shared, headers: &HeaderMap, host: &str) -> bool {
    match only(headers, &header::ORIGIN) {
        Some(origin) => shared.hosts.is_origin(origin, host),
        None => headers.get(header::ORIGIN).is_none() && has_token(shared, headers),
    }
}

fn is_known(shared: &Shared, headers: &HeaderMap) -> bool {
    let mut cookies = headers.get_all(header::COOKIE).iter().filter_map(|value| value.to_str().ok());
    cookies.any(|cookies| shared.access.has_cookie(cookies)) || has_token(shared, headers)
}

fn has_token(shared: &Shared, headers: &HeaderMap) -> bool {
    let token = text(headers, &header::AUTHORIZATION).and_then(|value| value.strip_prefix("Bearer "));
    token.is_some_and(|token| shared.access.is_token(token))
}

fn text<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    headers.get(name).map(|value| value.to_str().unwrap_or("?"))
}

/// Returns the value of a header that must not occur twice.
fn only<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    let mut values = headers.get_all(name).iter();
    let value = values.next()?.to_str().ok();
    if values.next().is_some() { None } else { value }
}

fn refuse(why: &'static str) -> Response {
    (StatusCode::FORBIDDEN, why).into_response()
}

/// Sets the cookie and leads to the page without the key, so that the key is in no history.
fn welcome(shared: &Shared) -> Response {
    (StatusCode::SEE_OTHER, [(header::LOCATION, "/".to_owned()), (header::SET_COOKIE, shared.access.set_cookie())])
        .into_response()
}

/// The page that explains how to enter.
fn ask() -> Response {
    let (page, media) = assets::file("enter.html").unwrap_or_default();
    (StatusCode::FORBIDDEN, [(header::CONTENT_TYPE, media)], page.into_owned()).into_response()
}
