// dropfile PATH: drops a file on the window under the pointer's root, as a file manager would (XDND, version 5).

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <cstdio>
#include <cstring>
#include <string>

namespace {

struct Source {
    Display* display;
    Window own, target;
    Atom aware, selection, enter, position, status, drop, finished, copy, uri_list;

    explicit Source(Display* d) : display(d), own(XCreateSimpleWindow(d, DefaultRootWindow(d), 0, 0, 1, 1, 0, 0, 0)) {
        auto atom = [d](const char* name) { return XInternAtom(d, name, False); };
        aware = atom("XdndAware");
        selection = atom("XdndSelection");
        enter = atom("XdndEnter");
        position = atom("XdndPosition");
        status = atom("XdndStatus");
        drop = atom("XdndDrop");
        finished = atom("XdndFinished");
        copy = atom("XdndActionCopy");
        uri_list = atom("text/uri-list");
        target = findTarget(DefaultRootWindow(d));
    }

    // The first window below that takes drops.
    Window findTarget(Window window) const {
        Atom type = None;
        int format = 0;
        unsigned long count = 0, left = 0;
        unsigned char* data = nullptr;
        XGetWindowProperty(display, window, aware, 0, 1, False, AnyPropertyType, &type, &format, &count, &left, &data);
        if (data) XFree(data);
        if (type != None) return window;
        Window root = None, parent = None, *children = nullptr, found = None;
        unsigned int child_count = 0;
        if (!XQueryTree(display, window, &root, &parent, &children, &child_count)) return None;
        for (unsigned int i = 0; i < child_count && found == None; ++i) found = findTarget(children[i]);
        if (children) XFree(children);
        return found;
    }

    void send(Atom message, long l1, long l2, long l3, long l4) const {
        XEvent event = {};
        event.xclient.type = ClientMessage;
        event.xclient.window = target;
        event.xclient.message_type = message;
        event.xclient.format = 32;
        const long values[] = {long(own), l1, l2, l3, l4};
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = values[i];
        XSendEvent(display, target, False, NoEventMask, &event);
        XFlush(display);
    }

    void answer(const XSelectionRequestEvent& request, const std::string& uri) const {
        XChangeProperty(display, request.requestor, request.property, uri_list, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(uri.data()), int(uri.size()));
        XEvent event = {};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = request.requestor;
        event.xselection.selection = request.selection;
        event.xselection.target = request.target;
        event.xselection.property = request.property;
        event.xselection.time = request.time;
        XSendEvent(display, request.requestor, False, NoEventMask, &event);
        XFlush(display);
    }
};

// False after ten seconds without an event.
bool nextEvent(Display* display, XEvent& event) {
    if (XPending(display) == 0) {
        pollfd descriptor = {ConnectionNumber(display), POLLIN, 0};
        if (poll(&descriptor, 1, 10000) <= 0) return false;
    }
    XNextEvent(display, &event);
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    Display* display = argc == 2 ? XOpenDisplay(nullptr) : nullptr;
    if (!display) return 1;
    Source source(display);
    if (source.target == None) return 2;
    const std::string uri = std::string("file://") + argv[1] + "\r\n";
    XSetSelectionOwner(display, source.selection, source.own, CurrentTime);
    source.send(source.enter, 5L << 24, long(source.uri_list), 0, 0);
    source.send(source.position, 0, 100L << 16 | 100, CurrentTime, long(source.copy));
    XEvent event;
    while (nextEvent(display, event)) {
        if (event.type == SelectionRequest) source.answer(event.xselectionrequest, uri);
        if (event.type != ClientMessage) continue;
        if (event.xclient.message_type == source.status) source.send(source.drop, 0, CurrentTime, 0, 0);
        if (event.xclient.message_type == source.finished) return 0;
    }
    return 3;
}
