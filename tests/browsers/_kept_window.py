"""A window of WebKitGTK that keeps what pages store, as a reader's browser does; MiniBrowser under
its driver keeps nothing.

Run by the Python that has Debian's gi and WebKit2 4.1 (packages python3-gi and gir1.2-webkit2-4.1):

    python3 _kept_window.py FOLDER ADDRESS

Each line of standard input is an expression of JavaScript; its value comes back as a line of JSON.
"""

import json
import sys

import gi

gi.require_version("Gtk", "3.0")
gi.require_version("WebKit2", "4.1")
from gi.repository import GLib, Gtk, WebKit2  # noqa: E402  (the versions are asked for first)


def main(folder, address):
    kept = WebKit2.WebsiteDataManager(base_data_directory=folder, base_cache_directory=folder)
    context = WebKit2.WebContext.new_with_website_data_manager(kept)
    view = WebKit2.WebView.new_with_context(context)
    window = Gtk.Window(default_width=1000, default_height=700)
    window.add(view)
    window.show_all()
    view.connect("load-changed", _listen)
    view.load_uri(address)
    view.grab_focus()
    Gtk.main()


def _listen(view, step):
    """A script that is sent before the page is there is never answered."""
    if step == WebKit2.LoadEvent.FINISHED:
        GLib.io_add_watch(sys.stdin, GLib.IO_IN, lambda *_: _ask(view))


def _ask(view):
    asked = sys.stdin.readline()
    if not asked:
        Gtk.main_quit()
        return False
    script = f"JSON.stringify(({asked.strip()}) ?? null)"
    view.evaluate_javascript(script, -1, None, None, None, _tell)
    return True


def _tell(view, answer):
    try:
        told = view.evaluate_javascript_finish(answer).to_string()
    except GLib.Error as error:
        told = json.dumps({"error": error.message})
    print(told, flush=True)


main(*sys.argv[1:])
