// A click on a bar of a histogram shows how to select its cells.
document.addEventListener("click", function (event) {
  var bar = event.target.closest("rect[data-low]");
  if (!bar) {
    return;
  }
  var article = bar.closest("article");
  var box = article.querySelector(".pick");
  var name = article.dataset.criterion;
  var low = bar.dataset.low;
  var high = bar.dataset.high;
  article.querySelectorAll(".picked").forEach(function (other) {
    other.classList.remove("picked");
  });
  article.querySelectorAll("rect[data-low='" + low + "']").forEach(function (part) {
    part.classList.add("picked");
  });
  var ids = [];
  article.querySelectorAll("tr[data-value]").forEach(function (row) {
    var value = Number(row.dataset.value);
    if (value >= Number(low) && value <= Number(high)) {
      ids.push(row.dataset.cell);
      row.classList.add("picked");
    }
  });
  var step = "By criterion: Array=" + name + "; Range=Custom; Side=Inside; LowerLimit=" + low + "; UpperLimit=" + high;
  box.querySelector(".bar").textContent = bar.querySelector("title").textContent;
  box.querySelector(".query").textContent = "(" + name + " >= " + low + ") & (" + name + " <= " + high + ")";
  var mesh = document.querySelector("main").dataset.mesh; // none for a mesh that is not a file
  box.querySelector(".select").hidden = mesh === "''";
  box.querySelector(".command").textContent = "camaron select " + mesh + " --by '" + step + "' -o cells.csv";
  box.querySelector(".ids").textContent = ids.length ? "Among the worst cells below: " + ids.join(", ") : "";
  box.hidden = false;
});
