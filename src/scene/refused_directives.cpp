// Directives of pbrt that dsphere has no part for. What names the refused thing later is not told again.

#include "scene/directives.h"

namespace dsphere {

void mediumInterface(Statement s) {
    const Token inside = s.source.lexer.takeString("a medium's name");
    Token outside = inside;
    if (s.source.lexer.peek().is(Token::Kind::String)) outside = s.source.lexer.next();
    for (const Token& medium : {inside, outside})
        if (!medium.text.empty() && !s.state.media.contains(medium.text))
            failAt(medium.where, "medium {}: media are not supported; supported: \"\", none", described(medium));
    s.state.report.note(s.word.where, "MediumInterface", "changes nothing here: it names no medium");
}

void makeNamedMedium(Statement s) {
    const Token name = s.source.lexer.takeString("a medium's name");
    s.state.media.insert(name.text);
    failAt(s.word.where, "MakeNamedMedium {}: media are not supported", described(name));
}

void objectBegin(Statement s) {
    s.state.recovery.objects_refused = true;
    failAt(s.word.where, "ObjectBegin: instances are not supported; give each shape where it stands");
}

void objectEnd(Statement s) {
    if (s.state.recovery.objects_refused) throw AlreadyReported{};
    failAt(s.word.where, "ObjectEnd: instances are not supported");
}

void objectInstance(Statement s) {
    s.source.lexer.takeString("an object's name");
    if (s.state.recovery.objects_refused) throw AlreadyReported{};
    failAt(s.word.where, "ObjectInstance: instances are not supported; give each shape where it stands");
}

void import(Statement s) {
    failAt(s.word.where, "Import is not supported; supported: Include");
}

}  // namespace dsphere
