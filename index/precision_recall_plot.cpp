#include <array>

#include "index/report.h"
#include "index/report_text.h"

namespace ossuary::index {

namespace {

constexpr double kWidth = 720.0;
constexpr double kHeight = 480.0;
constexpr double kLeft = 64.0;
constexpr double kTop = 24.0;
constexpr double kRight = 24.0;
constexpr double kBottom = 56.0;

/// Told apart by people who see few colours, too (Okabe and Ito's set), and by their dashes.
constexpr std::array<std::string_view, 6> kColors = {"#0072b2", "#d55e00", "#009e73",
                                                     "#cc79a7", "#e69f00", "#56b4e9"};
constexpr std::array<std::string_view, 3> kDashes = {"none", "8 4", "2 4"};

double x_of(double recall) { return kLeft + recall * (kWidth - kLeft - kRight); }
double y_of(double precision) { return kHeight - kBottom - precision * (kHeight - kTop - kBottom); }

std::string line(double x1, double y1, double x2, double y2, std::string_view color) {
    return "<line x1=\"" + fixed(x1, 1) + "\" y1=\"" + fixed(y1, 1) + "\" x2=\"" + fixed(x2, 1) +
           "\" y2=\"" + fixed(y2, 1) + "\" stroke=\"" + std::string(color) + "\"/>\n";
}

std::string label(double x, double y, std::string_view anchor, std::string_view text) {
    return "<text x=\"" + fixed(x, 1) + "\" y=\"" + fixed(y, 1) + "\" text-anchor=\"" +
           std::string(anchor) + "\">" + markup_text(text) + "</text>\n";
}

std::string axes() {
    std::string svg;
    for (int i = 0; i <= 5; ++i) {
        const double share = 0.2 * i;
        svg += line(x_of(share), y_of(0.0), x_of(share), y_of(1.0), "#e3e6ea");
        svg += line(x_of(0.0), y_of(share), x_of(1.0), y_of(share), "#e3e6ea");
        svg += label(x_of(share), y_of(0.0) + 20.0, "middle", fixed(share, 1));
        svg += label(x_of(0.0) - 10.0, y_of(share) + 5.0, "end", fixed(share, 1));
    }
    svg += line(x_of(0.0), y_of(0.0), x_of(1.0), y_of(0.0), "#59636e");
    svg += line(x_of(0.0), y_of(0.0), x_of(0.0), y_of(1.0), "#59636e");
    svg += label((x_of(0.0) + x_of(1.0)) / 2.0, kHeight - 12.0, "middle", "Recall");
    const std::string middle = fixed((y_of(0.0) + y_of(1.0)) / 2.0, 1);
    svg += "<text transform=\"translate(18 " + middle +
           ") rotate(-90)\" text-anchor=\"middle\">Precision</text>\n";
    return svg;
}

std::string curve(const Evaluation& evaluation, std::string_view color, std::string_view dash) {
    std::string points;
    for (const ranking::PrecisionRecallPoint& each : evaluation.report.precision_recall) {
        if (!points.empty()) points += ' ';
        points += fixed(x_of(each.recall), 1) + "," + fixed(y_of(each.precision), 1);
    }
    return "<polyline fill=\"none\" stroke=\"" + std::string(color) +
           "\" stroke-width=\"2.5\" stroke-linejoin=\"round\" stroke-dasharray=\"" +
           std::string(dash) + "\" points=\"" + points + "\"><title>" +
           markup_text(evaluation_title(evaluation)) + "</title></polyline>\n";
}

}  // namespace

std::string precision_recall_svg(std::span<const Evaluation> evaluations) {
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " +
                      fixed(kWidth, 0) + " " + fixed(kHeight, 0) +
                      "\" role=\"img\" aria-label=\"Precision over recall\" "
                      "font-family=\"system-ui, sans-serif\" font-size=\"14\" fill=\"#1d232b\">\n"
                      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n" +
                      axes();
    for (std::size_t i = 0; i < evaluations.size(); ++i) {
        const std::string_view color = kColors[i % kColors.size()];
        const std::string_view dash = kDashes[(i / kColors.size()) % kDashes.size()];
        svg += curve(evaluations[i], color, dash);
        const double y = y_of(0.0) - 16.0 - 22.0 * static_cast<double>(evaluations.size() - 1 - i);
        svg += "<g stroke-width=\"2.5\" stroke-dasharray=\"" + std::string(dash) + "\">" +
               line(x_of(0.0) + 14.0, y - 5.0, x_of(0.0) + 44.0, y - 5.0, color) + "</g>";
        svg += label(x_of(0.0) + 52.0, y, "start", evaluation_title(evaluations[i]));
    }
    return svg + "</svg>\n";
}

}  // namespace ossuary::index
