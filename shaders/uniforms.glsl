// Uniform data at constant indices, which main() reads before all else (rule L3 of docs/design.md): lavapipe (Mesa 22.3) reads a
// uniform once for all lanes only where none can be masked, outside of every if and loop and before any return. Elsewhere each
// lane fetches it, some 28 instructions per float.
// No branch may depend on them alone (rule L2): lavapipe would set their values into a copy of the shader and compile that, at
// worst for every dispatch. So isKind() and its like ask the specialization constants first.
// Expects `params`, the parameters that are `pushed`.

const int kMainObject = kObjectCount == 1 || kOnlyDisplaced < 0 ? 0 : kOnlyDisplaced;
const int kPlainObject = kOnlyPlain < 0 ? 0 : kOnlyPlain;

ObjectData first_object;  // whose centre stands for the world's origin
ObjectData main_object;   // the scene's only object, or the only displaced one
MapData main_map;         // the main object's map, at its finest level of detail
ObjectData plain_object;  // the only one that is not displaced, if there are others
LightData only_light;
LightData infinite_light;  // if there is one

void readUniforms() {
    params = pushed;
    first_object = objects[0];
    main_object = objects[kMainObject];
    main_map = maps[kMainObject];
    plain_object = objects[kPlainObject];
    only_light = lights[0];
    infinite_light = lights[kInfiniteLight < 0 ? 0 : kInfiniteLight];
}
