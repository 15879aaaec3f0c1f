#include "web/api.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "test/support/scratch_folder.hpp"
#include "web/page_files.hpp"

namespace taut::web::api_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Api : public testing::Test {
 protected:
  ApiReply ask(const std::string& method, const std::string& path, const std::string& body = "",
               const std::string& name = "") {
    ApiRequest request{.method = method, .path = path, .query = {}, .body = body};
    if (!name.empty()) request.query["name"] = name;
    return answer(request, folder_, jobs_);
  }
  void await(const std::string& id) {
    for (auto news = jobs_.news(id); !news->ended();) news = jobs_.wait(id, news->version, std::chrono::minutes(10));
  }

  const taut_test::ScratchFolder scratch_;
  Folder folder_{scratch_.path()};
  Jobs jobs_{{.threads = 1}, [](const AskedDeck& deck, const auto&) {
               Result r;
               r.title = deck.text;
               return r;
             }};
};

TEST_F(Api, JobsFromTheDeckToTheResult) {
  const ApiReply made = ask("POST", "/api/jobs", R"({"text": "t", "name": "a.yaml", "files": {"b.csv": "x"}})");
  EXPECT_EQ(made.status, 201);
  const std::string id = Json::parse(made.body).at("id");
  await(id);
  const std::string job = "/api/jobs/" + id;
  EXPECT_EQ(Json::parse(ask("GET", job).body).at("page").at("title"), "t");
  EXPECT_EQ(Json::parse(ask("GET", job + "/deck").body),
            Json::parse(R"({"text": "t", "name": "a.yaml", "files": {"b.csv": "x"}, "set": []})"));
  EXPECT_EQ(ask("GET", job + "/report").type, "text/plain; charset=utf-8");
  EXPECT_NE(ask("GET", job + "/report").body.find("</html>"), std::string::npos);
  EXPECT_EQ(Json::parse(ask("GET", job + "/json").body).at("title"), "t");
  EXPECT_EQ(ask("GET", job + "/pictures").body, "[]");
  EXPECT_EQ(ask("GET", job + "/events").events_of, id);
  EXPECT_EQ(Json::parse(ask("GET", "/api/jobs").body).at("jobs").at(0).at("state"), "done");
  EXPECT_EQ(ask("POST", job + "/stop").status, 202);
  EXPECT_EQ(ask("DELETE", job).status, 200);
  EXPECT_EQ(ask("GET", job).status, 404);
}

TEST_F(Api, EventsAreWhatAReaderOfEventsUnderstands) {
  const std::string text = event_of({.id = "7", .name = "a\nb", .state = JobState::done});
  EXPECT_TRUE(text.starts_with("event: done\ndata: {\"id\":\"7\",\"name\":\"a\\nb\",")) << text;
  EXPECT_TRUE(text.ends_with("}\n\n"));
  EXPECT_TRUE(event_of({.id = "7"}).starts_with("event: progress\n"));
}

TEST_F(Api, FilesOfTheFolder) {
  EXPECT_EQ(ask("PUT", "/api/file", "text", "a.yaml").status, 200);
  EXPECT_EQ(ask("GET", "/api/file", "", "a.yaml").body, "text");
  EXPECT_EQ(Json::parse(ask("GET", "/api/files").body).at("names"), Json({"a.yaml"}));
  EXPECT_EQ(ask("GET", "/api/file", "", "../a.yaml").status, 403);
  EXPECT_EQ(ask("PUT", "/api/file", "text", "../a.yaml").status, 403);
  EXPECT_EQ(ask("PUT", "/api/file", "text", "a.sh").status, 403);
  EXPECT_EQ(ask("GET", "/api/file", "", "b.yaml").status, 404);
  EXPECT_EQ(ask("GET", "/api/file").status, 400);
  EXPECT_EQ(ask("DELETE", "/api/file", "", "a.yaml").status, 405);
  EXPECT_EQ(ask("PUT", "/api/file", std::string(17U << 20U, ' '), "a.yaml").status, 413);
}

TEST_F(Api, WhatIsNoDeckIsRefused) {
  const std::string deep = std::string(1000000, '[');
  for (const std::string& body :
       {std::string(), std::string("{"), std::string("[]"), std::string("7"), std::string("{}"),
        std::string(R"({"text": 7})"), std::string("{\"text\": \"\xFF\"}"),
        std::string(R"({"text": "", "files": ["a"]})"), std::string(R"({"text": "", "files": {"a": 1}})"),
        std::string(R"({"text": "", "set": "a"})"), deep, "{\"text\": " + deep}) {
    EXPECT_EQ(ask("POST", "/api/jobs", body).status, 400) << body.substr(0, 60);
  }
}

TEST_F(Api, WhatIsNotThereIsRefused) {
  for (const char* path :
       {"/api", "/api/", "/api/nothing", "/api/hello/x", "/api/jobs/1", "/api/jobs/x", "/api/jobs/-1",
        "/api/jobs/99999999999999999999", "/api/jobs/1/events", "/api/file/a.yaml", "/x"}) {
    EXPECT_EQ(ask("GET", path).status, 404) << path;
  }
  EXPECT_EQ(ask("DELETE", "/api/jobs").status, 405);
  EXPECT_EQ(ask("POST", "/api/schema").status, 405);
  EXPECT_EQ(Json::parse(ask("GET", "/api/hello").body).at("folder"), folder_.path().string());
}

TEST(AskedDeck, FilesOfADeckComeFromThePageAndThenFromBeyond) {
  const AskedDeck deck = asked_deck(R"({"text": "", "files": {"parts/../a.csv": "given", "../out.csv": "never",
                                        "/etc/out.csv": "never"}})");
  const app::Job alone = job_of(deck);
  EXPECT_EQ(alone.read("x/../a.csv"), "given");
  for (const char* path : {"../out.csv", "/etc/out.csv", "b.csv"}) {
    ASSERT_FALSE(alone.read(path));
    EXPECT_TRUE(alone.read(path).error().missing);
  }
  const app::Job served = job_of(deck, [](const std::string& path) { return "beyond " + path; });
  EXPECT_EQ(served.read("a.csv"), "given");
  EXPECT_EQ(served.read("../out.csv"), "beyond ../out.csv");
}

TEST(PageFiles, TheTokenStandsInTheAddressesOfThePage) {
  const taut_test::ScratchFolder scratch;
  const fs::path site = scratch.path() / "page" / "site";
  fs::create_directories(site);
  EXPECT_FALSE(page_in(page_places(scratch.path().string(), "/usr/bin/taut")));
  std::ofstream(site / "index.html")
      << "<html data-nonce=\"n\"><link href=\"style.css\"><script src=\"page.js\"></script>";
  std::ofstream(site / "page.js") << "script";
  std::ofstream(site / "style.css") << "style";
  EXPECT_EQ(page_in(page_places((scratch.path() / "page").string(), "/usr/bin/taut")), site);
  EXPECT_EQ(page_in(page_places(site.string(), "/usr/bin/taut")), site);
  const ServedPage page = read_page(site, "t0k");
  EXPECT_EQ(page.nonce, "n");
  EXPECT_EQ(page.files.at("/").text,
            "<html data-served=\"\" data-nonce=\"n\"><link href=\"style.css?token=t0k\">"
            "<script src=\"page.js?token=t0k\"></script>");
  EXPECT_EQ(page.files.at("/page.js").text, "script");
  std::ofstream(site / "index.html") << "another page";
  EXPECT_THROW(read_page(site, "t0k"), std::runtime_error);
}

TEST(PageFiles, TheInstalledPageComesBeforeThatOfASourceTree) {
  const auto places = page_places("", "/opt/taut/build/bin/taut");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0], "/opt/taut/build/share/taut/page/site");
  EXPECT_EQ(places[1], "/opt/taut/build-web/page/site");
}

}  // namespace taut::web::api_test
