"""A page from elsewhere, in the browser of somebody who has Onika open, neither sees nor moves anything (F17)."""

import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest

pytestmark = pytest.mark.page

TRY_ALL = """
async (address) => {
  const http = `http://${address}/`
  const socket = (path) => new Promise((end) => {
    const line = new WebSocket(`ws://${address}${path}`)
    line.onopen = () => line.send(JSON.stringify({ cid: 1, act: { t: 'Stop' } }))
    line.onmessage = () => end('it talks')
    line.onclose = () => end('refused')
  })
  const read = (how) => fetch(http, how).then((answer) => answer.text()).then(() => 'read', () => 'refused')
  const framed = () => new Promise((end) => {
    const frame = document.createElement('iframe')
    frame.onload = () => {
      try { end(frame.contentDocument?.body?.childElementCount ? 'shown' : 'refused') } catch { end('refused') }
    }
    frame.src = http
    document.body.append(frame)
  })
  const script = () => new Promise((end) => {
    const element = document.createElement('script')
    element.onload = () => end('loaded')
    element.onerror = () => end('refused')
    element.src = http
    document.body.append(element)
  })
  const posted = () => fetch(http, { method: 'POST', mode: 'no-cors', body: 'act=Stop', credentials: 'include' })
    .then((answer) => (answer.type === 'opaque' ? 'refused' : 'read'), () => 'refused')
  return {
    socket: await socket('/ws'),
    read: await read({}),
    with_cookie: await read({ credentials: 'include' }),
    framed: await framed(),
    script: await script(),
    posted: await posted(),
  }
}
"""


class _Foreign(BaseHTTPRequestHandler):
    """A page that somebody else serves, on this machine even, where cookies of another port are sent along."""

    def do_GET(self):
        body = b"<!doctype html><title>foreign</title><body>"
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_args):
        """Say nothing."""


@pytest.fixture
def foreign():
    server = ThreadingHTTPServer(("127.0.0.1", 0), _Foreign)
    thread = threading.Thread(target=server.serve_forever)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}/"
    server.shutdown()
    thread.join(10)
    server.server_close()


@pytest.fixture(scope="module")
def program(begin):
    return begin("--no-connect")


def test_a_foreign_page_sees_nothing_and_moves_nothing(program, page, foreign, excused):  # R-F01
    program.enter(page)
    address = page.evaluate("location.host")
    excused.append("WebSocket|CORS|Refused|ERR_|Failed to load|frame|sandbox|violates|status of")
    stranger = page.context.new_page()
    stranger.goto(foreign)
    tried = stranger.evaluate(TRY_ALL, address)
    assert {name: end for name, end in tried.items() if end != "refused"} == {}
    assert page.get_by_text("everything is stopped").count() == 0
