"""What a page asks of Python, counted."""

from __future__ import annotations

from playwright.sync_api import Page

COUNT = """() => {
    window.asked = [];
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (message, ...rest) {
        if (message.do === "request") window.asked.push(JSON.parse(message.text).kind);
        return post.call(this, message, ...rest);
    };
}"""
"""Every request to Python from now on, by its kind."""


def asked(page: Page) -> list[str]:
    return list(page.evaluate("window.asked"))
