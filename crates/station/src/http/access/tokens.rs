//! Who may do what: tokens.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use dobot_api::{Role, write_private};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The tokens that a station accepts: the file `tokens.toml`, which holds their digests only.
///
/// ```
/// use dobot_api::{Role, write_private};
/// use dobot_station::Tokens;
///
/// let folder = tempfile::tempdir()?;
/// let mut tokens = Tokens::open(&folder.path().join("tokens.toml"))?;
/// let token = tokens.add(Role::Control, "plotter")?;
/// assert_eq!(token.secret().len(), 64);
/// assert_eq!(tokens.list().collect::<Vec<_>>(), [("plotter", Role::Control)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Tokens {
    file: PathBuf,
    version: Option<Version>,
    known: Vec<Known>,
    /// How often the known tokens changed.
    changes: u64,
    /// The token of programs on the same machine, which is in no file of tokens.
    local: Option<[u8; 32]>,
}

impl Tokens {
    /// Reads the file; where there is none, no token is accepted.
    ///
    /// # Errors
    ///
    /// [`TokensError`] where it cannot be read or understood.
    pub fn open(file: &Path) -> Result<Self, TokensError> {
        let mut tokens = Self {
            file: file.to_owned(),
            version: None,
            known: Vec::new(),
            changes: 0,
            local: None,
        };
        tokens.follow()?;
        Ok(tokens)
    }

    /// Makes a token of 256 random bits. Only its digest is kept: it can be shown this once.
    ///
    /// # Errors
    ///
    /// [`TokensError`] where the name is taken or is no name, or the file cannot be written.
    pub fn add(&mut self, role: Role, name: &str) -> Result<Token, TokensError> {
        let token = Token::random().map_err(TokensError::Random)?;
        self.accept(role, name, &token)?;
        Ok(token)
    }

    /// Accepts a token that another station has made, so that its holder is known to both.
    ///
    /// # Errors
    ///
    /// As with [`add`](Self::add), and [`TokensError::Known`] where a token is accepted that is the same.
    pub fn accept(&mut self, role: Role, name: &str, token: &Token) -> Result<(), TokensError> {
        self.follow()?;
        if !is_name(name) {
            return Err(TokensError::Name(name.into()));
        }
        if self.known.iter().any(|token| token.name == name) {
            return Err(TokensError::Taken(name.into()));
        }
        let sha256 = hex(&digest(token.secret()));
        if let Some(same) = self.known.iter().find(|token| token.sha256 == sha256) {
            return Err(TokensError::Known(same.name.clone()));
        }
        self.known.push(Known {
            name: name.into(),
            role,
            shared: false,
            sha256,
            #[cfg(feature = "proofs")]
            key: Some(crate::http::proofs::public_key(token.secret())),
            #[cfg(not(feature = "proofs"))]
            key: None,
        });
        self.write()
    }

    /// Has the token of that name be for several people: each of them is who he calls himself. Any other token is that of one
    /// person, by its name.
    ///
    /// # Errors
    ///
    /// [`TokensError`] where there is none of that name, or the file cannot be written.
    pub fn share(&mut self, name: &str) -> Result<(), TokensError> {
        self.follow()?;
        let found = self.known.iter_mut().find(|token| token.name == name);
        let known = found.ok_or_else(|| TokensError::Unknown(name.into()))?;
        known.shared = true;
        self.write()
    }

    /// Whether the token of that name is for several people.
    #[must_use]
    pub fn is_shared(&self, name: &str) -> bool {
        self.known
            .iter()
            .any(|token| token.name == name && token.shared)
    }

    /// Whether this is the token of programs on the same machine.
    pub(crate) fn is_local(&self, token: &[u8; 32]) -> bool {
        self.local.is_some_and(|local| same(&local, token))
    }

    /// Removes a token: it is refused from now on.
    ///
    /// # Errors
    ///
    /// [`TokensError`] where there is none of that name, or the file cannot be written.
    pub fn remove(&mut self, name: &str) -> Result<(), TokensError> {
        self.follow()?;
        let before = self.known.len();
        self.known.retain(|token| token.name != name);
        if self.known.len() == before {
            return Err(TokensError::Unknown(name.into()));
        }
        self.write()
    }

    /// The names of all tokens, and what each may do.
    pub fn list(&self) -> impl Iterator<Item = (&str, Role)> {
        self.known.iter().map(|token| (&*token.name, token.role))
    }

    /// Makes the token of programs on the same machine.
    pub(crate) fn make_local(&mut self) -> Result<Token, TokensError> {
        let token = Token::random().map_err(TokensError::Random)?;
        self.local = Some(digest(token.secret()));
        Ok(token)
    }

    /// The file as it was read last, to be read anew without holding up those who ask for tokens meanwhile.
    pub(crate) fn source(&self) -> TokensFile {
        TokensFile {
            file: self.file.clone(),
            version: self.version,
        }
    }

    /// Takes what the file says now; while it cannot be understood, no token of it is accepted.
    pub(crate) fn apply(&mut self, read: Result<Option<TokensRead>, TokensError>) {
        match read {
            Ok(None) => {}
            Ok(Some(read)) => self.set(read.version, read.known),
            Err(_) if self.known.is_empty() => self.version = None,
            Err(_) => self.set(None, Vec::new()),
        }
    }

    /// How often the known tokens changed: whoever was let in before has to be checked again.
    pub(crate) const fn changes(&self) -> u64 {
        self.changes
    }

    fn set(&mut self, version: Option<Version>, known: Vec<Known>) {
        (self.version, self.known) = (version, known);
        self.changes += 1;
    }

    /// Name and role of whoever has the token with this digest, as the file was read last.
    pub(crate) fn known(&self, token: &[u8; 32]) -> Option<(String, Role)> {
        if self.local.is_some_and(|local| same(&local, token)) {
            return Some(("local program".into(), Role::Admin));
        }
        let digest = hex(token);
        let found = self.known.iter().fold(None, |found, it| {
            if same(it.sha256.as_bytes(), digest.as_bytes()) {
                Some(it)
            } else {
                found
            }
        });
        found.map(|token| (token.name.clone(), token.role))
    }

    /// The digest of the token of which this is a proof, as the file was read last.
    #[cfg(feature = "proofs")]
    pub(crate) fn proved(&self, statement: &[u8], proof: &[u8]) -> Option<[u8; 32]> {
        let is_proved = |token: &&Known| {
            let key = token.key.as_deref();
            key.is_some_and(|key| crate::http::proofs::is_proved(key, statement, proof))
        };
        let known = self.known.iter().find(is_proved)?;
        let digest = data_encoding::HEXLOWER.decode(known.sha256.as_bytes());
        digest.ok()?.try_into().ok()
    }

    /// Reads the file if it is not the one that was read last.
    pub(crate) fn follow(&mut self) -> Result<(), TokensError> {
        if let Some(read) = self.source().read()? {
            self.set(read.version, read.known);
        }
        Ok(())
    }

    fn write(&mut self) -> Result<(), TokensError> {
        let content = Content {
            token: self.known.clone(),
        };
        let text = toml::to_string(&content).expect("a list of tables of texts is TOML");
        write_private(&self.file, &text).map_err(|error| self.io(error))?;
        self.version = Version::of(&self.file).map_err(|error| self.io(error))?;
        self.changes += 1;
        Ok(())
    }

    fn io(&self, source: io::Error) -> TokensError {
        TokensError::io(&self.file, source)
    }
}

/// The file of tokens, as it was read last.
#[derive(Debug)]
pub(crate) struct TokensFile {
    file: PathBuf,
    version: Option<Version>,
}

/// What a file of tokens says.
#[derive(Debug)]
pub(crate) struct TokensRead {
    version: Option<Version>,
    known: Vec<Known>,
}

impl TokensFile {
    /// What it says now, if it is not the one that was read last.
    pub(crate) fn read(&self) -> Result<Option<TokensRead>, TokensError> {
        let io = |error| TokensError::io(&self.file, error);
        let version = Version::of(&self.file).map_err(io)?;
        if version == self.version {
            return Ok(None);
        }
        let mut text = String::new();
        if version.is_some() {
            text = fs::read_to_string(&self.file).map_err(io)?;
        }
        let content: Content = toml::from_str(&text).map_err(|error| TokensError::Content {
            file: self.file.display().to_string(),
            why: error.message().to_owned(),
        })?;
        let known = content.token;
        Ok(Some(TokensRead { version, known }))
    }
}

impl TokensError {
    fn io(file: &Path, source: io::Error) -> Self {
        Self::Io {
            file: file.display().to_string(),
            source,
        }
    }
}

/// A secret that says who a client is. It shows itself when it is asked to, and never in a log.
#[derive(Clone, PartialEq, Eq)]
pub struct Token(String);

impl Token {
    /// The secret: 64 hexadecimal digits.
    #[must_use]
    pub fn secret(&self) -> &str {
        &self.0
    }

    /// One that a station has made.
    ///
    /// # Errors
    ///
    /// [`TokensError::NoToken`] where it has not 64 hexadecimal digits.
    pub fn of_secret(secret: &str) -> Result<Self, TokensError> {
        let is_secret = secret.len() == 64 && secret.bytes().all(|byte| byte.is_ascii_hexdigit());
        let token = is_secret.then(|| Self(secret.to_ascii_lowercase()));
        token.ok_or(TokensError::NoToken)
    }

    /// A new one of 256 random bits.
    pub(crate) fn random() -> Result<Self, getrandom::Error> {
        let mut bits = [0; 32];
        getrandom::fill(&mut bits)?;
        Ok(Self(hex(&bits)))
    }
}

impl std::fmt::Debug for Token {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Token(secret)")
    }
}

/// Why the tokens are not as they were asked to be.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TokensError {
    /// The file cannot be read or written.
    #[error("{file}")]
    Io {
        /// The file.
        file: String,
        /// Why.
        #[source]
        source: io::Error,
    },
    /// The file holds something else.
    #[error("{file} does not hold tokens: {why}")]
    Content {
        /// The file.
        file: String,
        /// What is wrong with it.
        why: String,
    },
    /// A name is no name.
    #[error(
        "{0:?} is no name for a token; names have 1 to 40 letters, digits, dots, dashes and spaces"
    )]
    Name(String),
    /// A name is given already.
    #[error("there is a token of the name {0:?} already; remove it first")]
    Taken(String),
    /// The same token is accepted under another name.
    #[error("this token is accepted already, under the name {0:?}")]
    Known(String),
    /// It is no token.
    #[error("a token is 64 hexadecimal digits, as `dobot token add` shows them; this is none")]
    NoToken,
    /// No token has this name.
    #[error("there is no token of the name {0:?}")]
    Unknown(String),
    /// The system has no random bits.
    #[error("the system gives no random bits")]
    Random(#[source] getrandom::Error),
}

/// The file.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Content {
    #[serde(default)]
    token: Vec<Known>,
}

/// What is kept of a token.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Known {
    name: String,
    role: Role,
    /// It is for several people.
    #[serde(default, skip_serializing_if = "is_not")]
    shared: bool,
    sha256: String,
    /// By what proofs with the token are checked; absent where the program that accepted it could not make them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    key: Option<String>,
}

#[expect(
    clippy::trivially_copy_pass_by_ref,
    reason = "this is how serde asks for it"
)]
const fn is_not(it: &bool) -> bool {
    !*it
}

/// What changes when the file changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Version {
    written: SystemTime,
    len: u64,
    number: u64,
}

impl Version {
    fn of(file: &Path) -> io::Result<Option<Self>> {
        let found = match fs::metadata(file) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            found => found?,
        };
        Ok(Some(Self {
            written: found.modified()?,
            len: found.len(),
            #[cfg(unix)]
            number: std::os::unix::fs::MetadataExt::ino(&found),
            #[cfg(not(unix))]
            number: 0,
        }))
    }
}

fn is_name(name: &str) -> bool {
    let fits = |c: char| c.is_alphanumeric() || matches!(c, '.' | '-' | '_' | ' ');
    (1..=40).contains(&name.chars().count()) && name.chars().all(fits)
}

pub(crate) fn digest(secret: &str) -> [u8; 32] {
    Sha256::digest(secret.as_bytes()).into()
}

pub(crate) fn hex(bytes: &[u8]) -> String {
    data_encoding::HEXLOWER.encode(bytes)
}

/// Compares all bytes, whatever they are, so that the time that it takes tells nothing.
fn same(one: &[u8], other: &[u8]) -> bool {
    let differences = one.iter().zip(other).fold(0, |all, (a, b)| all | (a ^ b));
    one.len() == other.len() && std::hint::black_box(differences) == 0
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn empty() -> (tempfile::TempDir, Tokens) {
        let folder = tempfile::tempdir().unwrap();
        let tokens = Tokens::open(&folder.path().join("tokens.toml")).unwrap();
        (folder, tokens)
    }

    /// Whose token this is, by the file as it is now.
    fn holder(tokens: &mut Tokens, secret: &str) -> Option<(String, Role)> {
        let read = tokens.source().read();
        tokens.apply(read);
        tokens.known(&digest(secret))
    }

    #[test]
    fn a_token_is_known_by_its_name_and_role_and_no_other_text_is() {
        let (_folder, mut tokens) = empty();
        let token = tokens.add(Role::Watch, "screen").unwrap();
        let screen = Some(("screen".to_owned(), Role::Watch));
        assert_eq!(holder(&mut tokens, token.secret()), screen);
        let mut other = token.secret().to_owned();
        other.replace_range(63.., if other.ends_with('0') { "1" } else { "0" });
        for wrong in ["", "screen", &other, &token.secret()[..63]] {
            assert_eq!(holder(&mut tokens, wrong), None, "{wrong}");
        }
    }

    #[test]
    fn the_file_and_what_is_printed_for_debugging_do_not_hold_the_secret() {
        let (folder, mut tokens) = empty();
        let token = tokens.add(Role::Admin, "me").unwrap();
        let local = tokens.make_local().unwrap();
        let file = fs::read_to_string(folder.path().join("tokens.toml")).unwrap();
        for text in [file, format!("{token:?} {local:?} {tokens:?}")] {
            assert!(!text.contains(token.secret()), "{text}");
            assert!(!text.contains(local.secret()), "{text}");
        }
    }

    #[test]
    fn a_digest_from_the_file_is_no_token() {
        let (_folder, mut tokens) = empty();
        let token = tokens.add(Role::Admin, "me").unwrap();
        assert_eq!(holder(&mut tokens, &hex(&digest(token.secret()))), None);
    }

    #[test]
    fn what_another_program_adds_and_removes_counts_at_once() {
        let (folder, mut station) = empty();
        let mut program = Tokens::open(&folder.path().join("tokens.toml")).unwrap();
        let token = program.add(Role::Control, "plotter").unwrap();
        assert!(holder(&mut station, token.secret()).is_some());
        program.remove("plotter").unwrap();
        assert_eq!(holder(&mut station, token.secret()), None);
    }

    #[test]
    fn a_file_that_cannot_be_understood_opens_no_door() {
        let (folder, mut station) = empty();
        let token = station.add(Role::Control, "plotter").unwrap();
        fs::write(folder.path().join("tokens.toml"), "token = 7").unwrap();
        assert_eq!(holder(&mut station, token.secret()), None);
        let error = Tokens::open(&folder.path().join("tokens.toml")).unwrap_err();
        assert!(
            error.to_string().contains("does not hold tokens"),
            "{error}"
        );
    }

    #[test]
    fn names_are_unique_and_readable() {
        let (_folder, mut tokens) = empty();
        tokens.add(Role::Watch, "one").unwrap();
        assert!(matches!(
            tokens.add(Role::Watch, "one"),
            Err(TokensError::Taken(_))
        ));
        assert!(matches!(
            tokens.add(Role::Watch, "a\nb"),
            Err(TokensError::Name(_))
        ));
        assert!(matches!(tokens.remove("two"), Err(TokensError::Unknown(_))));
    }

    #[test]
    fn two_tokens_are_never_the_same() {
        assert_ne!(Token::random().unwrap(), Token::random().unwrap());
    }
}
