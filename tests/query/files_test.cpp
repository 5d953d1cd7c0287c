// Files of rays and of answers.

#include "query/hitwriter.h"
#include "query/suns.h"
#include "scene/parser.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace dsphere::query {
namespace {

using test::expectError;

class RayFile : public testing::Test {
  protected:
    RayFile()
        : scene_(parseScene("WorldBegin Shape \"displacedsphere\" \"float radius\" 2", "test", {})),
          maps_(loadSceneMaps(scene_)),
          geography_(scene_, maps_, Frame::World) {}

    static std::string npy(const std::string& header, const std::vector<double>& values, char version = 1) {
        std::string bytes = "\x93NUMPY";
        bytes += {version, '\0', char(header.size() & 255), char(header.size() >> 8)};
        if (version > 1) bytes += std::string(2, '\0');
        bytes += header;
        bytes.append(reinterpret_cast<const char*>(values.data()), 8 * values.size());
        return bytes;
    }
    static std::string header(const std::string& shape, const std::string& type = "'<f8'",
                              const std::string& fortran = "False") {
        return "{'descr': " + type + ", 'fortran_order': " + fortran + ", 'shape': " + shape + ", }\n";
    }

    std::vector<QueryRay> read(const std::string& bytes, std::size_t most = 2) {
        const auto reader = openRays(folder_.write("rays", bytes).string(), {}, geography_);
        std::vector<QueryRay> rays;
        std::vector<double> room;
        while (true) {
            const RayRows rows = reader->read(room, most);
            if (rows.count == 0) return rays;
            EXPECT_LE(rows.count, most);
            for (std::size_t i = 0; i < rows.count; ++i) rays.push_back(rows.at(i));
        }
    }
    void refuses(const std::string& bytes, const std::string& part) {
        expectError(ExitCode::InvalidInput, part, [&] { read(bytes); });
        expectError(ExitCode::InvalidInput, "rays", [&] { read(bytes); });
    }

    test::TempFolder folder_;
    Scene scene_;
    SceneMaps maps_;
    Geography geography_;
};

TEST_F(RayFile, NumPyOfSixAndEightColumnsInAllVersions) {
    const std::vector<double> six = {1, 2, 3, 4, 5, 6, 11, 12, 13, 14, 15, 16, 21, 22, 23, 24, 25, 26};
    for (char version : {1, 2, 3}) {
        const auto rays = read(npy(header("(3, 6)"), six, version));
        ASSERT_EQ(rays.size(), 3u);
        EXPECT_EQ(rays[2].origin[0], 21.0);
        EXPECT_EQ(rays[1].direction[2], 16.0);
        EXPECT_EQ(rays[0].t_min, 0.0);
        EXPECT_TRUE(std::isinf(rays[0].t_max));
    }
    const auto rays = read(npy(header("(1, 8)"), {1, 2, 3, 4, 5, 6, 7, 8}));
    ASSERT_EQ(rays.size(), 1u);
    EXPECT_EQ(rays[0].t_min, 7.0);
    EXPECT_EQ(rays[0].t_max, 8.0);
    EXPECT_TRUE(read(npy(header("(0, 6)"), {})).empty());
}

TEST_F(RayFile, WhatIsNoArrayOfRaysIsRefusedByName) {
    const std::vector<double> six(6), seven(7);
    refuses(npy(header("(1, 7)"), seven), "has the shape (1, 7); expected a float64 array of the shape (N, 6)");
    refuses(npy(header("(6,)"), six), "has the shape (6,)");
    refuses(npy(header("(1, 1, 6)"), six), "has the shape (1, 1, 6)");
    refuses(npy(header("()"), six), "has the shape ()");
    refuses(npy(header("(1, 6)", "'<f4'"), six), "holds float32 ('<f4')");
    refuses(npy(header("(1, 6)", "'>f8'"), six), "holds big-endian float64 ('>f8')");
    refuses(npy(header("(1, 6)", "'<i8'"), six), "holds the type '<i8'");
    refuses(npy(header("(1, 6)", "[('a', '<f8')]"), six), "holds records of several fields");
    refuses(npy(header("(1, 6)", "'<f8'", "True"), six), "fortran_order");
    refuses(npy(header("(2, 6)"), six), "its 2 rays of 6 values take");
    refuses(npy("{}\n", six), "has no 'descr'");
    refuses(npy("{'descr': '<f8', 'shape': (1," + std::string(60000, ' '), six), "has no 'shape'");
    refuses(npy(header("(1, 6)"), six).substr(0, 20), "ends within its NumPy header");
    refuses(std::string("\x93NUMPY\x07\0\0\0", 10), "version 7.0");
}

TEST_F(RayFile, EveryTruncationIsRefused) {
    const std::string whole = npy(header("(1, 6)"), std::vector<double>(6));
    for (std::size_t length = 6; length < whole.size(); ++length)
        expectError(ExitCode::InvalidInput, "", [&] { read(whole.substr(0, length)); });
}

TEST_F(RayFile, CsvSaysRaysInThreeWays) {
    auto rays = read("# a comment\r\n dx , dy,dz,ox,oy,oz,tmax\r\n\r\n+1,2,3,4,5,6e0,inf\n1,2,3,nan,5,6,9");
    ASSERT_EQ(rays.size(), 2u);
    EXPECT_EQ(rays[0].direction[0], 1.0);
    EXPECT_EQ(rays[0].origin[2], 6.0);
    EXPECT_TRUE(std::isinf(rays[0].t_max));
    EXPECT_TRUE(std::isnan(rays[1].origin[0]));
    EXPECT_EQ(rays[1].t_max, 9.0);

    rays = read("\xef\xbb\xbflat,lon,alt,azimuth,elevation\n0,90,1,0,0\n0,0,1,90,0\n30,0,0,180,-90\n");
    ASSERT_EQ(rays.size(), 3u);
    EXPECT_NEAR(rays[0].origin[0], 3.0, 1e-15);  // a radius of 2 and an altitude of 1, on +x
    EXPECT_NEAR(rays[0].direction[1], 1.0, 1e-15);
    EXPECT_NEAR(rays[1].direction[0], 1.0, 1e-15);  // east of +z is +x
    EXPECT_NEAR(rays[2].direction[1], -0.5, 1e-15);
    EXPECT_NEAR(rays[2].origin[1], 1.0, 1e-15);

    rays = read("from_x,from_y,from_z,to_lat,to_lon,to_ground\n0,0,5,0,0,1\n");
    ASSERT_EQ(rays.size(), 1u);
    EXPECT_NEAR(rays[0].direction[2], -2.0, 1e-15);
    EXPECT_EQ(rays[0].t_max, 1.0);
}

TEST_F(RayFile, WrongCsvIsRefusedWithItsPlace) {
    refuses("ox,oy,oz,dx,dy\n", "rays:1: the columns ox,oy,oz,dx,dy lack 'dz'; expected ox,oy,oz,dx,dy,dz, or lat");
    refuses("ox,oy,oz,dx,dy,dz,name\n", "the column 'name' is unknown");
    refuses("ox,oy,oz,dx,dy,dz,dz\n", "the column 'dz' stands twice");
    refuses("OX,oy,oz,dx,dy,dz\n", "lack 'ox'");
    refuses("lat,lon,alt\n", "lack 'azimuth'");
    refuses("\n", "is empty");
    refuses("ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6\n1,2,3,4,5\n", "rays:3: 5 values, expected 6");
    refuses("ox,oy,oz,dx,dy,dz\n1,2,3,4,5,6x\n", "rays:2: the value of 'dz' is '6x', expected a number");
    refuses("ox,oy,oz,dx,dy,dz\n1,2,,4,5,6\n", "rays:2: the value of 'oz' is ''");
    refuses("lat,lon,alt,azimuth,elevation\n91,0,0,0,0\n", "rays:2: a latitude of 91");
    refuses("ox,oy,oz,dx,dy,dz\n+-1,2,3,4,5,6\n", "rays:2: the value of 'ox' is '+-1', expected a number");
    refuses("ox,oy,oz,dx,dy,dz\n1e999,2,3,4,5,6\n", "the value of 'ox' is '1e999', which a double cannot hold");
    refuses("0,0,4,0,0,-1\n", "rays:1: begins with numbers; the first line names the columns");
    refuses("ox;oy;oz;dx;dy;dz\n", "rays:1: has no commas: 'ox;oy;oz;dx;dy;dz'");
    refuses("ox oy oz dx dy dz\n", "has no commas");
    refuses("ox,oy,oz,dx,dy,dz,\n", "rays:1: a column has no name (a comma too many?)");
    refuses("ox,oy,oz,dx,dy,dz\n" + std::string(2 << 20, '0'), "has a line of more than 1048576 bytes");
    refuses("ox,oy,oz,dx,dy,dz\r0,0,4,0,0,-1\r", "end in carriage returns alone");
    refuses(std::string("\xff\xfeo\0x\0", 6), "is neither a NumPy array nor a CSV text");
    refuses(std::string("\x80\x04\x95\xa3\0\0", 6), "is neither a NumPy array nor a CSV text");
    refuses(std::string("PK\x03\x04\0\0", 6), "is an archive, as numpy.savez writes");
    expectError(ExitCode::Failure, "missing", [&] { openRays("missing", {}, geography_); });
    expectError(ExitCode::InvalidInput, "no NumPy file",
                [&] { openRays(folder_.write("rays", "ox\n").string(), FileFormat::Npy, geography_); });
}

TEST_F(RayFile, PlacesNeedADisplacedSphere) {
    const Scene scene = parseScene("WorldBegin Shape \"sphere\"", "test", {});
    const SceneMaps maps = loadSceneMaps(scene);
    const Geography nowhere(scene, maps, Frame::World);
    expectError(ExitCode::InvalidInput, "need a displacedsphere",
                [&] { nowhere.point(0, 0, 0, Geography::Above::Sphere, "rays:2"); });
}

TEST_F(RayFile, RecordsAreWrittenAsNumPyReadsThem) {
    const Record record({"status", "P", "lit", "t_low"});
    EXPECT_EQ(record.bytes(), 1u + 24u + 4u + 8u);
    std::vector<Answer> answers(2);
    QueryHit& hit = answers[0].hit;
    hit.status = QueryStatus::Hit;
    hit.position = {1.5, 2.0, 3.0};
    hit.lit = 7;
    std::vector<std::byte> bytes(2 * record.bytes());
    record.put(bytes.data(), answers, std::vector<Truth>(2));
    const std::string name = (folder_.path() / "hits.npy").string();
    HitWriter writer(name, FileFormat::Npy, record, {});  // the count comes at the end
    writer.write(bytes);
    EXPECT_FALSE(std::filesystem::exists(name)) << "not before it is whole";
    writer.finish();
    const std::string file = test::readBytes(name);
    const std::size_t length = std::uint8_t(file[8]) + 256u * std::uint8_t(file[9]);
    EXPECT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    EXPECT_EQ((10 + length) % 64, 0u);
    EXPECT_TRUE(test::holds(file,
                            "{'descr': [('status', '|u1'), ('P', '<f8', (3,)), ('lit', '<u4'), ('t_low', '<f8')], "
                            "'fortran_order': False, 'shape': (2,), }"));
    ASSERT_EQ(file.size(), 10 + length + bytes.size());
    EXPECT_EQ(std::memcmp(file.data() + 10 + length, bytes.data(), bytes.size()), 0);

    HitWriter text((folder_.path() / "hits.csv").string(), FileFormat::Csv, record, {});
    text.write(bytes);
    text.finish();
    EXPECT_EQ(test::readBytes(folder_.path() / "hits.csv"),
              "status,P_x,P_y,P_z,lit,t_low\n1,1.5,2,3,7,nan\n0,nan,nan,nan,0,nan\n");
}

TEST_F(RayFile, FieldsAndEndingsAreChecked) {
    expectError(ExitCode::Usage, "unknown field 'x', expected some of status,t,P", [] { Record({"x"}); });
    expectError(ExitCode::Usage, "'t' stands twice", [] { Record({"t", "t"}); });
    expectError(ExitCode::Usage, "ends in .npy or .csv", [] { formatOfName("hits.txt"); });
    expectError(ExitCode::Usage, "begins with its length", [] { HitWriter("-", FileFormat::Npy, Record({"t"}), {}); });
}

class SunFile : public testing::Test {
  protected:
    std::vector<Sun> read(const std::string& text) { return readSuns(folder_.write("suns.csv", text).string()); }
    void refuses(const std::string& text, const std::string& part) {
        expectError(ExitCode::InvalidInput, part, [&] { read(text); });
    }

    test::TempFolder folder_;
};

TEST_F(SunFile, OneALine) {
    const std::vector<Sun> suns =
        read("# a day\nlon, lat ,distance,radius,name\n10,-1.5,inf,0.27,noon\n\n370,2,1.5,0,dusk\n");
    ASSERT_EQ(suns.size(), 2u);
    EXPECT_EQ(suns[0].longitude, 10.0);
    EXPECT_EQ(suns[0].latitude, -1.5);
    EXPECT_FALSE(suns[0].distance);
    EXPECT_EQ(suns[0].radius, 0.27);
    EXPECT_EQ(suns[0].name, "noon");
    EXPECT_EQ(suns[1].distance, 1.5);
    EXPECT_EQ(read("lat,lon\n1,2\n")[0].longitude, 2.0);
}

TEST_F(SunFile, WhatIsWrongIsNamedWithItsLine) {
    refuses("", "is empty");
    refuses("lon,lat\n", "holds no suns");
    refuses("lon\n1\n", "suns.csv:1: lacks the column 'lat'");
    refuses("lon,lat,time\n1,2,3\n", "'time' is unknown");
    refuses("lon,lat,lon\n1,2,3\n", "'lon' stands twice");
    refuses("lon,lat\n1,2\n1,91\n", "suns.csv:3: a latitude of 91");
    refuses("lon,lat\nx,2\n", "suns.csv:2: the value of 'lon' is 'x'");
    refuses("lon,lat\nnan,2\n", "a longitude of nan");
    refuses("lon,lat,distance\n1,2,0.5\n", "a distance of 0.5, expected above 1 R");
    refuses("lon,lat,radius\n1,2,90\n", "a radius of 90");
    refuses("lon,lat,name\n1,2,a\n3,4,a\n", "suns.csv:3: the name 'a' stands twice");
    refuses("lon,lat\n1\n", "1 values, expected 2");
    expectError(ExitCode::Failure, "none.csv", [&] { readSuns((folder_.path() / "none.csv").string()); });
}

}  // namespace
}  // namespace dsphere::query
