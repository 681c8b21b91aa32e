"""A headless Chromium without a network, for tests of pages."""
import contextlib
import pathlib
import tempfile

CHROMIUM = pathlib.Path("/usr/bin/chromium")
DRIVER = pathlib.Path("/usr/bin/chromedriver")
FLAGS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--host-resolver-rules=MAP * ~NOTFOUND", "--window-size=1320,1500")


def missing():
    """What is not installed that the tests need, in words; empty if nothing is."""
    lacking = [package for package, path in (("chromium", CHROMIUM), ("chromium-driver", DRIVER))
               if not path.exists()]
    try:
        import selenium  # noqa: F401
    except ImportError:
        lacking.append("python3-selenium")
    return ", ".join(lacking)


def options(profile, flags):
    from selenium import webdriver
    chosen = webdriver.ChromeOptions()
    chosen.binary_location = str(CHROMIUM)
    for flag in (*FLAGS, *flags, f"--user-data-dir={profile}"):
        chosen.add_argument(flag)
    chosen.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return chosen


class Page:
    """A page that is open in the browser."""

    def __init__(self, driver):
        self.driver = driver

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def text(self, selector):
        return self.run("return document.querySelector(arguments[0])?.textContent ?? ''", selector)

    def set(self, selector, value, event="input"):
        """Sets a slider or a choice as a user does."""
        self.run("const e = document.querySelector(arguments[0]); e.value = arguments[1];"
                 "e.dispatchEvent(new Event(arguments[2], {bubbles: true}));",
                 selector, value, event)

    def click(self, selector):
        self.run("document.querySelector(arguments[0]).click()", selector)

    def picture(self, selector):
        """PNG of an element as it is drawn."""
        return self.driver.find_element("css selector", selector).screenshot_as_png

    def errors(self):
        """Complaints of the browser, those of its software renderer about speed left out."""
        return [m["message"] for m in self.driver.get_log("browser")
                if "GPU stall due to ReadPixels" not in m["message"]]

    def requests(self):
        """What the page has asked for, itself left out."""
        return self.run("return performance.getEntriesByType('resource').map(e => e.name)")


@contextlib.contextmanager
def opened(path, *flags):
    """The page of a file, in a browser of its own, started with these flags too."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    with tempfile.TemporaryDirectory() as profile:
        driver = webdriver.Chrome(service=Service(str(DRIVER)), options=options(profile, flags))
        try:
            driver.get(pathlib.Path(path).resolve().as_uri())
            yield Page(driver)
        finally:
            driver.quit()
