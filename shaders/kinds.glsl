// Kinds of objects, lights and materials. Masks have a bit per kind.

// Whether something of the kind `own`, one of the `possible`, is of that `kind`. Where specialization constants tell, `own` is not asked
// (rule L2).
bool isAmong(const int own, const int kind, const int possible) {
    return (possible & 1 << kind) != 0 && (possible == 1 << kind || own == kind);
}
