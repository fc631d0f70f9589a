/* A logger, as an outside partner of the task `logger`: writes rows of numbers to a file, and acknowledges each.
 *
 *     cc -O2 -o logger docs/examples/logger.c && ./logger run.csv tcp:127.0.0.1:7802
 *
 * Without an address it talks over its standard input and output. A message is one line of JSON; this program needs no
 * library for it, as it looks only for "id", "ask", "t" and "row", which the task writes in one known way.
 */
#include <arpa/inet.h>
#include <netdb.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

enum { LONGEST = 65537, GUESTS = 16 };

struct guest {
  int in, out;
  size_t filled;
  char line[LONGEST];
};

static FILE *file;
static long rows;

static void fail(const char *what) {
  perror(what);
  exit(1);
}

/* Where the value behind "name": begins, or NULL. */
static const char *value_of(const char *line, const char *name) {
  char key[32];
  snprintf(key, sizeof key, "\"%s\":", name);
  const char *at = strstr(line, key);
  if (at == NULL) return NULL;
  at += strlen(key);
  while (*at == ' ') at++;
  return at;
}

/* One line of a task and the answer to it; 0 where the task is to be hung up on. */
static int serve(struct guest *guest) {
  char answer[160];
  const char *id = value_of(guest->line, "id"), *ask = value_of(guest->line, "ask");
  const char *t = value_of(guest->line, "t"), *row = value_of(guest->line, "row");
  const char *end = row != NULL && *row == '[' ? strchr(row, ']') : NULL;
  if (id == NULL) return 0;
  if (ask == NULL || strncmp(ask, "\"log\"", 5) != 0 || t == NULL || end == NULL) {
    snprintf(answer, sizeof answer, "{\"id\":%ld,\"error\":\"a logger knows log, with t and row\"}\n", atol(id));
  } else {
    fprintf(file, "%.9f,%.*s\n", atof(t), (int)(end - row - 1), row + 1);
    if (fflush(file) != 0) fail("writing");
    snprintf(answer, sizeof answer, "{\"id\":%ld,\"rows\":%ld}\n", atol(id), ++rows);
  }
  size_t length = strlen(answer);
  return write(guest->out, answer, length) == (ssize_t)length;
}

/* What a task has said by now; 0 where it has hung up. */
static int hear(struct guest *guest) {
  ssize_t count = read(guest->in, guest->line + guest->filled, LONGEST - 1 - guest->filled);
  if (count <= 0) return 0;
  guest->filled += (size_t)count;
  guest->line[guest->filled] = 0;
  char *end;
  while ((end = memchr(guest->line, '\n', guest->filled)) != NULL) {
    *end = 0;
    if (!serve(guest)) return 0;
    size_t used = (size_t)(end + 1 - guest->line);
    guest->filled -= used;
    memmove(guest->line, end + 1, guest->filled + 1);
  }
  return guest->filled < LONGEST - 1;
}

static int listen_at(const char *address) {
  int server;
  if (strncmp(address, "unix:", 5) == 0) {
    struct sockaddr_un place = {.sun_family = AF_UNIX};
    snprintf(place.sun_path, sizeof place.sun_path, "%s", address + 5);
    unlink(place.sun_path);
    server = socket(AF_UNIX, SOCK_STREAM, 0);
    if (bind(server, (struct sockaddr *)&place, sizeof place) != 0) fail(address);
  } else {
    char host[256];
    const char *port = strrchr(address, ':');
    struct addrinfo *found, wanted = {.ai_socktype = SOCK_STREAM};
    if (strncmp(address, "tcp:", 4) != 0 || port == address + 3) {
      fprintf(stderr, "expected tcp:HOST:PORT or unix:PATH, found %s\n", address);
      exit(2);
    }
    snprintf(host, sizeof host, "%.*s", (int)(port - address - 4), address + 4);
    if (getaddrinfo(host, port + 1, &wanted, &found) != 0) fail(address);
    server = socket(found->ai_family, SOCK_STREAM, 0);
    int yes = 1;
    setsockopt(server, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (bind(server, found->ai_addr, found->ai_addrlen) != 0) fail(address);
    freeaddrinfo(found);
  }
  if (listen(server, GUESTS) != 0) fail(address);
  return server;
}

int main(int count, char **words) {
  static struct guest guests[GUESTS];
  const char *address = count > 2 ? words[2] : getenv("ONIKA_PARTNER");
  if (count < 2) {
    fprintf(stderr, "usage: logger FILE [tcp:HOST:PORT | unix:PATH]\n");
    return 2;
  }
  if ((file = fopen(words[1], "w")) == NULL) fail(words[1]);
  signal(SIGPIPE, SIG_IGN);
  if (address == NULL) {
    struct guest *only = &guests[0];
    only->in = 0, only->out = 1;
    while (hear(only)) continue;
    return 0;
  }
  struct pollfd waits[GUESTS + 1] = {{.fd = listen_at(address), .events = POLLIN}};
  for (int k = 1; k <= GUESTS; k++) waits[k] = (struct pollfd){.fd = -1, .events = POLLIN};
  for (;;) {
    if (poll(waits, GUESTS + 1, -1) < 0) fail("poll");
    for (int k = 1; k <= GUESTS; k++) {
      if (waits[k].fd >= 0 && waits[k].revents != 0 && !hear(&guests[k - 1])) {
        close(waits[k].fd);
        waits[k].fd = -1;
      }
    }
    if (waits[0].revents == 0) continue;
    int line = accept(waits[0].fd, NULL, NULL), free_place = 1;
    while (free_place <= GUESTS && waits[free_place].fd >= 0) free_place++;
    if (line >= 0 && free_place > GUESTS) close(line);
    if (line < 0 || free_place > GUESTS) continue;
    guests[free_place - 1] = (struct guest){.in = line, .out = line};
    waits[free_place].fd = line;
  }
}
